in vec2 place;
in vec3 spot;
uniform vec3 normal;
uniform vec3 paint;
uniform float opacity;
uniform vec2 from;      // where the middle is [squares]
uniform float squares;  // in a unit
uniform float reach;
uniform float aspect;   // of a picture instead of squares, its width over its height; 0: none
out vec4 result;

// 1 and 0 by turns, even where squares are smaller than pixels: the integral of the pattern over a pixel.
float checks(vec2 at) {
  vec2 wide = max(fwidth(at), 1e-6);
  vec2 sums = 2.0 * (abs(fract((at - 0.5 * wide) * 0.5) - 0.5) - abs(fract((at + 0.5 * wide) * 0.5) - 0.5)) / wide;
  return 0.5 - 0.5 * sums.x * sums.y;
}

void main() {
  float off = dot(place, place) / (reach * reach), fade = clamp(1.6 * (1.0 - off), 0.0, 1.0);
  float lit = 0.62 + 0.38 * max(dot(normal, light), 0.0);
  vec2 at = place * squares * vec2(1.0, aspect) + from;
  vec3 color = lit * (aspect > 0.0 ? pictured(paint, texture(picture, vec2(at.x, -at.y)))
                                   : paint * mix(0.88, 1.0, checks(place * squares + from)));
  result = vec4(shown(color), fade * fade * opacity);
}
