// A line of light, bright at its head and gone at its tail. See glow.frag.
in vec2 place;
flat in vec4 paint_of;
out vec4 result;
void main() {
  float across = 1.0 - place.x * place.x, along = 0.5 + 0.5 * place.y, tip = clamp((1.0 - place.y) * 8.0, 0.0, 1.0);
  float a = across * along * tip * paint_of.a;
  if (a <= 0.0) discard;
  result = vec4(paint_of.rgb * a, a * veil);
}
