in vec3 spot;
flat in vec3 along_of;
flat in vec2 bar;
out vec4 result;
void main() {
  float t = entry(spot + light * (-spot.y / light.y), along_of, -light, bar.x, 1e9);
  if (t > 1e8) discard;
  result = vec4(bar.y - t * light.y);
}
