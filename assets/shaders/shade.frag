in vec2 place;
uniform sampler2D shadow;
uniform vec3 dark;  // sRGB
out vec4 result;
void main() {
  vec2 spot = on_map(place);
  float shade = 0.0;
  if (smooth_edges) {  // of the first: over 3 x 3 pixels
    vec2 half_pixel = 0.5 / vec2(textureSize(shadow, 0));
    for (int k = 0; k < 4; k++)
      shade += 0.25 * texture(shadow, spot / all_maps + half_pixel * (2.0 * vec2(k & 1, k >> 1) - 1.0)).r;
  } else {
    shade = texture(shadow, spot / all_maps).r;
  }
  for (int k = 1; k < maps; k++)
    shade = max(shade, texture(shadow, (corner_of(k) + edge_of(k) * spot) / all_maps).r);
  result = vec4(dark, 0.42 * shade * min(1.0, 2.0 * fade_at(place)) * strength);
}
