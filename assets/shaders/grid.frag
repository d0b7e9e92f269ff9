in vec2 place;
uniform vec2 origin;    // in squares
uniform float squares;  // per unit of distance
uniform vec3 ink;       // sRGB
out vec4 result;

float lines(vec2 at, vec2 pixels, float thick) {
  vec2 far_off = abs(fract(at - 0.5) - 0.5) * pixels;
  vec2 line = clamp(thick + 0.5 - far_off, 0.0, 1.0) * clamp(0.5 * pixels - 0.5, 0.0, 1.0);
  return max(line.x, line.y);
}

void main() {
  vec2 at = place * squares + origin, pixels = 1.0 / max(fwidth(at), 1e-6);  // of a square
  float fade = fade_at(place), slant = min(12.0 * abs(level) * inversesqrt(dot(place, place) + level * level), 1.0);
  float grid = max(0.16 * lines(at, pixels, 0.5), 0.26 * lines(at * 0.2, pixels * 5.0, 0.6));
  result = vec4(ink, grid * fade * fade * slant * strength);
}
