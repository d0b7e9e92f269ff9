uniform float level;    // height of the ground
uniform vec2 middle;    // of the drawn part
uniform float reach;    // half its edge
out vec3 spot;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 at = middle + corner * reach;
  spot = vec3(at.x, level, at.y);
  gl_Position = camera * vec4(spot, 1.0);
}
