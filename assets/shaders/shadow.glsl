uniform vec2 shadow_middle;
uniform float shadow_reach;
uniform float level;
uniform vec3 light;
uniform float size;  // of the scene
// Where a place's shadow falls on the ground.
vec2 fall(vec3 place) { return place.xz - light.xz * ((place.y - level) / light.y); }
vec4 on_map(vec2 at) { return vec4((at - shadow_middle) / shadow_reach, 0.0, 1.0); }
// Half the width of the soft edge, at a height above the ground.
float softness(float radius, float height) { return 0.15 * radius + 0.10 * max(height, 0.0); }
