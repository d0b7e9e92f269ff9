// How high above the ground a line of light first meets something, by where it falls on the ground.
uniform float level;
uniform vec3 light;
vec2 fall(vec3 place) { return place.xz - light.xz * ((place.y - level) / light.y); }
vec4 drawn(vec2 at) { return vec4(2.0 * on_map(at) - 1.0, 0.0, 1.0); }
