in vec3 spot;
in vec3 normal_at;
in vec4 paint_at;
out vec4 result;
void main() {
  float a = seen(paint_at.a);
  if (a < 1.0 / 256.0) discard;
  result = vec4(shown(shade(paint_at.rgb, normalize(normal_at), -normalize(spot))), a);
}
