layout(location = 0) in vec3 place;
out float height;
void main() {
  height = place.y - level;
  gl_Position = drawn(fall(place));
}
