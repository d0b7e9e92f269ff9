in vec2 off;
flat in vec2 along_of;
flat in vec3 edge;
out vec4 result;
void main() {
  float part = clamp(dot(off, along_of) / max(dot(along_of, along_of), 1e-20), 0.0, 1.0);
  float soft = mix(edge.y, edge.z, part);
  float s = clamp((edge.x + soft - length(off - along_of * part)) / (2.0 * soft), 0.0, 1.0);
  result = vec4(s * s * (3.0 - 2.0 * s) * edge.x / max(edge.x, soft));
}
