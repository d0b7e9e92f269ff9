// How high above the ground a line of light first meets something that is not seen through, by where it falls on the
// ground.
uniform float level;
uniform vec3 light;
vec2 fall(vec3 place) { return place.xz - light.xz * ((place.y - level) / light.y); }
vec4 drawn(vec2 at) {
  vec3 p = deep_on_map(at);
  return vec4(p.xy, 0.0, p.z);
}
