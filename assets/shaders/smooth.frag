// What was found, even over the pattern of 4 x 4 pixels in which it was.
uniform sampler2D found;
uniform float near_by;
out vec4 result;
void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(found, 0) - 1;
  float z = texelFetch(found, here, 0).g, sum = 0.0, weights = 0.0;
  if (z < -1e3) {
    result = vec4(1.0, z, 0.0, 0.0);
    return;
  }
  for (int x = -2; x < 2; x++)
    for (int y = -2; y < 2; y++) {
      vec2 one = texelFetch(found, clamp(here + ivec2(x, y), ivec2(0), most), 0).rg;
      float weight = max(1.0 - abs(one.g - z) / (0.5 * near_by), 1e-4);
      sum += weight * one.r;
      weights += weight;
    }
  result = vec4(sum / weights, z, 0.0, 0.0);
}
