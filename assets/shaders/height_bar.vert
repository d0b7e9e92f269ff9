layout(location = 0) in vec4 from;
layout(location = 1) in vec4 to;
layout(location = 2) in vec4 paint;  // its opacity at the end
out vec3 spot;  // on the ground, from one end
flat out vec3 along_of;
flat out vec2 bar;  // radius, height of that end
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 a = fall(from.xyz), b = fall(to.xyz);
  float size = length(b - a), wide = from.w / light.y;
  vec2 u = size > 0.0 ? (b - a) / size : vec2(1, 0);
  vec2 at = 0.5 * (a + b) + u * corner.x * (0.5 * size + wide) + vec2(-u.y, u.x) * corner.y * wide;
  spot = vec3(at.x, level, at.y) - from.xyz;
  along_of = to.xyz - from.xyz;
  bar = vec2(from.w, from.y - level);
  gl_Position = to.w > 0.5 || paint.w < 1.0 ? vec4(2.0) : drawn(at);
}
