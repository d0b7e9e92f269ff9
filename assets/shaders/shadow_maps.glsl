// Maps of the ground in one texture, each half as wide as the one before: the first at its left, the others above each
// other at its right. Lengths in edges of the first.
const int maps = 5;
const vec2 all_maps = vec2(1.5, 1.0);
float edge_of(int k) { return exp2(-float(k)); }
vec2 corner_of(int k) { return k == 0 ? vec2(0.0) : vec2(1.0, 1.0 - 2.0 * edge_of(k)); }
uniform mat3 to_map;
uniform vec2 widths;  // along and across: so long on the ground is what a map is wide, over its depth squared and its depth
// Place on a map, from -1 to 1, times its depth.
vec3 deep_on_map(vec2 at) { return to_map * vec3(at, 1.0); }
// Place on a map, from 0 to 1.
vec2 on_map(vec2 at) {
  vec3 p = deep_on_map(at);
  return 0.5 + 0.5 * p.xy / p.z;
}
// Size of a pixel of a map that has so many a side.
float pixel_at(vec2 at, float pixels) {
  float depth = deep_on_map(at).z;
  return max(depth * widths.x, widths.y) * depth / pixels;
}
