layout(location = 0) in vec4 from;
layout(location = 1) in vec4 to;
layout(location = 2) in vec4 paint;  // its opacity at the end
out vec2 off;
flat out vec2 along_of;
flat out vec4 edge;  // radius, softness at both ends, opacity
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 a = fall(from.xyz), b = fall(to.xyz);
  float heights = max(from.y, to.y) - level, size = length(b - a);
  float pixel_a = pixel_at(a, pixels), pixel_b = pixel_at(b, pixels);
  edge = vec4(from.w, softness(from.w, from.y - level, pixel_a), softness(from.w, to.y - level, pixel_b), paint.w);
  float wide = edge.x + max(edge.y, edge.z);
  vec2 u = size > 0.0 ? (b - a) / size : vec2(1, 0);
  along_of = b - a;
  vec2 at = 0.5 * (a + b) + u * corner.x * (0.5 * size + wide) + vec2(-u.y, u.x) * corner.y * wide;
  off = at - a;
  gl_Position = heights < -from.w || edge.x < 0.03 * min(edge.y, edge.z) || to.w > 0.5 ? vec4(2.0) : drawn(at, map_for(min(edge.y, edge.z), min(pixel_a, pixel_b)));
}
