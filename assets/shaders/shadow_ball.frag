in vec2 off;
flat in vec2 edge;
out vec4 result;
void main() {
  float s = clamp((edge.x + edge.y - length(off)) / (2.0 * edge.y), 0.0, 1.0);
  result = vec4(s * s * (3.0 - 2.0 * s) * edge.x / max(edge.x, edge.y));
}
