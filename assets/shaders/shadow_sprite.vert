layout(location = 0) in vec3 place;
layout(location = 2) in vec4 paint;  // its opacity at the end
layout(location = 3) in vec2 at;  // on the picture
out float dark;
out vec2 at_of;
void main() {
  dark = dark_at(place) * paint.w;
  at_of = at;
  gl_Position = drawn(fall(place), 0);
}
