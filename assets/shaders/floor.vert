// A round piece of a plane on which things rest.
uniform vec3 middle;
uniform vec3 along_x;  // of length 1, in the plane
uniform vec3 along_y;
uniform float reach;  // its radius
out vec2 place;       // from the middle, along both
out vec3 spot;
void main() {
  float angle = 2.0 * 3.1415926536 * float(gl_VertexID) / corners;
  place = vec2(cos(angle), sin(angle)) * (reach / cos(3.1415926536 / corners));
  spot = middle + along_x * place.x + along_y * place.y;
  gl_Position = camera * vec4(spot, 1.0);
}
