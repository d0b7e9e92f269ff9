// Darkens the picture by what was found at half as many pixels a side, of the four about each those that are as far off.
uniform sampler2D found;
uniform sampler2D depth;
uniform vec2 depth_row;
uniform float near_by;
out vec4 result;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(found, 0) - 1, first = here >> 1;
  vec2 one[4];
  for (int i = 0; i < 4; i++) one[i] = texelFetch(found, clamp(first + ivec2(i & 1, i >> 1), ivec2(0), most), 0).rg;
  if (min(min(one[0].r, one[1].r), min(one[2].r, one[3].r)) > 0.996) discard;
  float z = -depth_row.y / (2.0 * texelFetch(depth, here, 0).r - 1.0 + depth_row.x), sum = 0.0, weights = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 off = abs(2 * (first + ivec2(i & 1, i >> 1)) - here);
    float weight = (off.x + off.y < 2 ? 2.0 : 1.0) * max(1.0 - abs(one[i].g - z) / (0.5 * near_by), 1e-4);
    sum += weight * one[i].r;
    weights += weight;
  }
  result = vec4(vec3(sum / weights), 1.0);
}
