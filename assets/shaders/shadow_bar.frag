in vec2 off;
flat in vec2 along_of;
flat in vec4 edge;
out vec4 result;
void main() {
  float part = clamp(dot(off, along_of) / max(dot(along_of, along_of), 1e-20), 0.0, 1.0);
  result = vec4(edge.w * darkness(edge.x, mix(edge.y, edge.z, part), length(off - along_of * part)));
}
