in vec3 spot;
in vec3 normal_at;
in vec4 paint_at;
in vec2 at_of;
out vec4 result;
void main() {
  vec4 texel = texture(picture, at_of);
  float a = seen(paint_at.a);
  if (dot(normal_at, normal_at) > 0.25) {
    if (a < least) discard;
    result = vec4(shown(shade(pictured(paint_at.rgb, texel), normalize(normal_at), -normalize(spot))), a);
    return;
  }
  // A sprite.
  a *= coverage(texel.a - 0.5);
  if (a < least) discard;
  result = vec4(shown(paint_at.rgb * opaque(texel)), a);
}
