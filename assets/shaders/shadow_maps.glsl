// Maps of the ground in one texture, each half as wide as the one before: the first at its left, the others above each
// other at its right. Lengths in edges of the first.
const int maps = 5;
const vec2 all_maps = vec2(1.5, 1.0);
float edge_of(int k) { return exp2(-float(k)); }
vec2 corner_of(int k) { return k == 0 ? vec2(0.0) : vec2(1.0, 1.0 - 2.0 * edge_of(k)); }
uniform vec2 shadow_middle;
uniform float shadow_reach;  // half of what a map shows of the ground
// Place on a map, from 0 to 1.
vec2 on_map(vec2 at) { return 0.5 + 0.5 * (at - shadow_middle) / shadow_reach; }
