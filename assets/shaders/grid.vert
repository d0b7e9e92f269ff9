// A round piece of the ground.
out vec2 place;
void main() {
  float angle = 2.0 * 3.1415926536 * float(gl_VertexID) / corners;
  place = middle + vec2(cos(angle), sin(angle)) * (reach / cos(3.1415926536 / corners));
  gl_Position = camera * vec4(place.x, level, place.y, 1.0);
}
