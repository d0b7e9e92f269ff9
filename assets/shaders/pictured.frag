in vec3 spot;
in vec3 normal_at;
in vec3 paint_at;
in vec2 at_of;
out vec4 result;
void main() {
  vec4 texel = texture(picture, at_of);
  if (dot(normal_at, normal_at) > 0.25) {
    result = vec4(shown(shade(pictured(paint_at, texel), normalize(normal_at), -normalize(spot))), 1.0);
    return;
  }
  // A sprite.
  float a = coverage(texel.a - 0.5);
  if (a < least) discard;
  result = vec4(shown(paint_at * opaque(texel)), a);
}
