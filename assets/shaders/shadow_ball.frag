in vec2 off;
flat in vec2 edge;
out vec4 result;
void main() {
  result = vec4(darkness(edge.x, edge.y, length(off)));
}
