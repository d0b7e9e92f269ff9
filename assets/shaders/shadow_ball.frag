in vec2 off;
flat in vec3 edge;
out vec4 result;
void main() {
  result = vec4(edge.z * darkness(edge.x, edge.y, length(off)));
}
