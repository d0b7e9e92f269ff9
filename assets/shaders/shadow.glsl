uniform float level;
uniform vec3 light;
uniform float size;   // of the scene
uniform float pixels;  // of the first map, a side
// Where a place's shadow falls on the ground.
vec2 fall(vec3 place) { return place.xz - light.xz * ((place.y - level) / light.y); }
// Half the width of the soft edge of what is that high above the ground, over pixels of that size.
float softness(float radius, float height, float pixel) {
  return max(0.15 * radius + 0.10 * max(height, 0.0), 1.25 * pixel);
}
// How dark a round thing of a radius is at a distance from its middle: even within, thinned where it is all soft edge.
float darkness(float radius, float soft, float off) {
  float s = clamp((radius + soft - off) / min(2.0 * soft, radius + soft), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s) * radius / max(radius, soft);
}
// The map on which an edge that soft is some pixels wide.
int map_for(float soft, float pixel) { return clamp(int(floor(log2(soft / (2.0 * pixel)))), 0, maps - 1); }
#ifndef FRAGMENT
// How dark the shadow is of what has sharp edges.
float dark_at(vec3 place) { return place.y < level ? 0.0 : 1.0 / (1.0 + 1.2 * (place.y - level) / size); }
// Nothing goes over the edge to another map.
vec4 drawn(vec2 at, int k) {
  vec3 p = deep_on_map(at);
  gl_ClipDistance[0] = p.z - p.x;
  gl_ClipDistance[1] = p.z + p.x;
  gl_ClipDistance[2] = p.z - p.y;
  gl_ClipDistance[3] = p.z + p.y;
  vec2 middle = corner_of(k) + 0.5 * edge_of(k);
  return vec4((2.0 * middle / all_maps - 1.0) * p.z + edge_of(k) * p.xy / all_maps, 0.0, p.z);
}
#endif
