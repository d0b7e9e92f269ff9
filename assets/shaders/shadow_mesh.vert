layout(location = 0) in vec3 place;
out float dark;
void main() {
  dark = place.y < level ? 0.0 : 1.0 / (1.0 + 1.2 * (place.y - level) / size);
  gl_Position = on_map(fall(place));
}
