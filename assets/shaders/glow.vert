// A square that faces the eye.
layout(location = 0) in vec4 disc;   // centre, radius
layout(location = 1) in vec4 paint;  // colour as shown, opacity
out vec2 place;
flat out vec4 paint_of;
void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 f = normalize(disc.xyz);
  vec3 s = normalize(cross(f, abs(f.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  paint_of = paint;
  gl_Position = camera * vec4(disc.xyz + (s * place.x + cross(s, f) * place.y) * disc.w, 1.0);
}
