// Places are relative to the eye, in units of the camera's distance, in the world's axes; colours are linear.
uniform mat4 camera;      // projection * view
uniform vec3 backward;    // camera's z axis
uniform vec2 depth_row;   // of the projection: clip z = x * view z + y
uniform float pixel;      // size of a pixel at distance 1
uniform vec3 light;       // direction to the key light
uniform float rim;        // light from behind, at the edges of things

float depth_of(vec3 place) {
  float z = dot(backward, place);
  return 0.5 * (depth_row.x * z + depth_row.y) / -z + 0.5;
}

vec3 shown(vec3 color) { return sqrt(clamp(color, 0.0, 1.0)); }

vec3 shade(vec3 color, vec3 normal, vec3 to_eye) {
  vec3 sky = mix(vec3(0.38, 0.335, 0.30), vec3(0.52, 0.54, 0.57), 0.5 + 0.5 * normal.y);
  float key = max(dot(normal, light), 0.0), facing = max(dot(normal, to_eye), 0.0);
  float gleam = max(dot(normal, normalize(light + to_eye)), 0.0), edge = 1.0 - facing;
  for (int i = 0; i < 5; i++) gleam *= gleam;  // to the 32nd power
  vec3 lit = color * (sky + key * vec3(0.62, 0.59, 0.54) + 0.16 * facing);
  return lit + 0.22 * gleam + rim * edge * edge * edge * sky;
}
