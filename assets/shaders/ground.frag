in vec3 spot;
uniform vec2 middle;
uniform float reach;
uniform vec2 origin;         // of the grid, in squares
uniform float squares;       // per unit of distance
uniform float strength;      // 0 … 1
uniform sampler2D shadow;
uniform vec2 shadow_middle;
uniform float shadow_reach;
uniform vec3 ink;            // sRGB, of the grid
uniform vec3 dark;           // sRGB, of shadows
out vec4 result;

float lines(vec2 at, float thick) {
  vec2 w = max(fwidth(at), 1e-6);
  vec2 far_off = abs(fract(at - 0.5) - 0.5) / w;
  vec2 line = clamp(thick + 0.5 - far_off, 0.0, 1.0) * clamp(0.5 / w - 0.5, 0.0, 1.0);
  return max(line.x, line.y);
}

void main() {
  vec2 at = spot.xz * squares + origin;
  float fade = length(spot.xz - middle) / reach;
  fade = clamp(1.0 - fade * fade, 0.0, 1.0);
  float slant = clamp(abs(spot.y) / length(spot) * 12.0, 0.0, 1.0);
  float grid = max(0.16 * lines(at, 0.5), 0.26 * lines(at / 5.0, 0.6)) * fade * fade * slant;
  float shade = 0.0;
  vec2 uv = 0.5 * (spot.xz - shadow_middle) / shadow_reach + 0.5;
  if (all(greaterThan(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)))) {
    vec2 e = vec2(1.2, 0.4) / vec2(textureSize(shadow, 0)), f = vec2(-e.y, e.x);
    shade = 0.25 * (texture(shadow, uv + e).r + texture(shadow, uv - e).r + texture(shadow, uv + f).r + texture(shadow, uv - f).r);
  }
  float all = grid + (1.0 - grid) * 0.42 * shade * min(1.0, 2.0 * fade);
  result = vec4(mix(dark, ink, grid / max(all, 1e-6)), all * strength);
}
