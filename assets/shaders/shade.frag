in vec2 place;
in vec2 spot;
uniform sampler2D shadow;
uniform vec3 dark;  // sRGB
out vec4 result;
void main() {
  float shade = 0.0;
  for (int k = 0; k < maps; k++)
    shade = max(shade, texture(shadow, (corner_of(k) + edge_of(k) * spot) / all_maps).r);
  result = vec4(dark, 0.42 * shade * min(1.0, 2.0 * fade_at(place)) * strength);
}
