uniform float level;
uniform vec3 light;
uniform float size;   // of the scene
uniform float texel;  // size of a pixel of the first map
// Where a place's shadow falls on the ground.
vec2 fall(vec3 place) { return place.xz - light.xz * ((place.y - level) / light.y); }
// Half the width of the soft edge, at a height above the ground.
float softness(float radius, float height) { return max(0.15 * radius + 0.10 * max(height, 0.0), 1.25 * texel); }
// How dark a round thing of a radius is at a distance from its middle: even within, thinned where it is all soft edge.
float darkness(float radius, float soft, float off) {
  float s = clamp((radius + soft - off) / min(2.0 * soft, radius + soft), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s) * radius / max(radius, soft);
}
// The map on which an edge that soft is some pixels wide.
int map_for(float soft) { return clamp(int(floor(log2(soft / (2.0 * texel)))), 0, maps - 1); }
vec4 drawn(vec2 at, int k) {
  return vec4(2.0 * (corner_of(k) + edge_of(k) * on_map(at)) / all_maps - 1.0, 0.0, 1.0);
}
