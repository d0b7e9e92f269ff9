// What of its light a place gets: things between it and the key light, and things near it that hide the sky.
uniform sampler2D depth;
uniform sampler2D heights;
uniform vec2 depth_row;  // of the projection
uniform vec2 slopes;    // of the picture's edges
uniform mat4 turn;      // from the world's axes to the camera's
uniform float near_by;  // how far things hide the sky
uniform float ground;   // how much of it is there, 0 … 1
out vec4 result;        // what is left, and where

const int spots = 9, rays = 6;

float z_at(vec2 at) { return -depth_row.y / (2.0 * texture(depth, at).r - 1.0 + depth_row.x); }
vec3 seen(vec2 at) {
  float z = z_at(at);
  return vec3((1.0 - 2.0 * at) * slopes, 1.0) * z;
}
// From a pixel to its neighbour, on the side where the surface goes on.
vec3 along(vec3 p, vec2 at, vec2 step_by) {
  vec3 on = seen(at + step_by) - p, back = p - seen(at - step_by);
  return abs(on.z) < abs(back.z) ? on : back;
}

void main() {
  vec2 wide = 1.0 / vec2(textureSize(depth, 0)), at = (2.0 * floor(gl_FragCoord.xy) + 0.5) * wide;
  vec3 up = turn[1].xyz, p = seen(at), way = vec3((2.0 * at - 1.0) * slopes, -1.0);
  float meets = level / dot(up, way), far_off = -p.z, strength = 1.0;
  bool bare = ground > 0.0 && meets > 0.0 && meets < far_off;
  if (bare) {
    p = way * meets;
    strength = ground;
  }
  mat3 back = transpose(mat3(turn));
  vec3 place = back * p;
  vec2 of_map = abs(on_map(place.xz) - 0.5);
  if (bare ? max(of_map.x, of_map.y) > 0.5 : texture(depth, at).r >= 1.0) {
    result = vec4(1.0, -1e4, 0.0, 0.0);
    return;
  }
  strength *= clamp(2.0 + 0.25 * p.z, 0.0, 1.0);  // depths are coarse far off
  vec3 n = bare ? up : normalize(cross(along(p, at, vec2(wide.x, 0.0)), along(p, at, vec2(0.0, wide.y))));
  ivec2 pixel_of = ivec2(gl_FragCoord.xy) & 3;
  float dither = float((pixel_of.x * 4 + pixel_of.y * 9) & 15) / 16.0;

  // The sky (after M. McGuire and others, scalable ambient obscurance, 2012).
  float reach = clamp(near_by, -0.02 * p.z * slopes.y, -0.24 * p.z * slopes.y), sum = 0.0;
  for (int i = 0; i < spots; i++) {
    float part = (float(i) + dither) / float(spots), angle = 6.2831853 * (dither + 5.0 * part);
    vec2 off = vec2(cos(angle), sin(angle)) * (part * reach);
    vec3 v = seen(at + 0.5 * off / (slopes * -p.z)) - p;
    float vv = dot(v, v), f = max(reach * reach - vv, 0.0);
    sum += f * f * f * max(dot(v, n) - 0.02 * reach, 0.0) / (vv + 0.04 * reach * reach);
  }
  float open = max(1.0 - 3.0 * sum / (pow(reach, 5.0) * float(spots)), 0.25);

  // The key light.
  vec3 normal = back * n;
  float key = max(dot(normal, light), 0.0), lit = 0.0;
  float height = place.y - level, pixels = float(textureSize(heights, 0).x);
  float cell = pixel_at(place.xz - light.xz * (height / light.y), pixels);
  // Over what the surface rises within the spots.
  place += light * (cell * (0.25 + 2.0 * length(normal.xz) / max(key, 0.1)));
  height = place.y - level;
  if (height > 4.0 * cell && key > 0.0) {  // below that the maps of shadows have it
    vec2 spot = on_map(place.xz - light.xz * (height / light.y));
    float soft = 3.0 / pixels;
    for (int i = 0; i < rays; i++) {
      float angle = 6.2831853 * (dither + 0.382 * float(i)), part = sqrt((float(i) + 0.5) / float(rays));
      lit += step(texture(heights, spot + soft * part * vec2(cos(angle), sin(angle))).r, height);
    }
    lit /= float(rays);
  } else {
    lit = 1.0;
  }
  float sky = mix(0.335, 0.54, 0.5 + 0.5 * normal.y) + 0.16 * max(dot(n, -normalize(p)), 0.0), direct = 0.59 * key;
  float left = open * (sky + direct * lit) / (sky + direct);
  result = vec4(mix(1.0, sqrt(left), strength), p.z, 0.0, 0.0);
}
