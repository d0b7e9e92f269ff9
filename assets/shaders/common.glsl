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

#ifdef FRAGMENT
// Opacity at an edge where q falls through 0, one pixel wide.
float coverage(float q) { return clamp(q / max(fwidth(q), 1e-20) + 0.5, 0.0, 1.0); }
#endif

vec3 shown(vec3 color) { return pow(clamp(color, 0.0, 1.0), vec3(1.0 / 2.2)); }

vec3 shade(vec3 color, vec3 normal, vec3 to_eye) {
  vec3 sky = mix(vec3(0.38, 0.335, 0.30), vec3(0.52, 0.54, 0.57), 0.5 + 0.5 * normal.y);
  float key = max(dot(normal, light), 0.0);
  vec3 half_way = normalize(light + to_eye);
  float shine = 0.22 * pow(max(dot(normal, half_way), 0.0), 48.0);
  float edge = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
  vec3 lit = color * (sky + key * vec3(0.62, 0.59, 0.54) + 0.16 * max(dot(normal, to_eye), 0.0));
  return lit + shine + rim * edge * sky;
}
