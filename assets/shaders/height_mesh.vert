layout(location = 0) in vec3 place;
layout(location = 2) in vec4 paint;  // its opacity at the end
out float height;
void main() {
  height = place.y - level;
  gl_Position = paint.w < 1.0 ? vec4(2.0) : drawn(fall(place));
}
