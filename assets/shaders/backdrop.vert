out float height;  // 0 at the bottom of the picture, 1 at its top
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  height = 0.5 * corner.y + 0.5;
  gl_Position = vec4(corner, 1.0, 1.0);
}
