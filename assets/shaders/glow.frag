// A soft disc of light. It adds its colour and takes half as much of what is behind, so that it shows on a light ground.
in vec2 place;
flat in vec4 paint_of;
out vec4 result;
void main() {
  float q = max(1.0 - dot(place, place), 0.0), a = q * q * paint_of.a;
  if (a <= 0.0) discard;
  result = vec4(paint_of.rgb * a, a * veil);
}
