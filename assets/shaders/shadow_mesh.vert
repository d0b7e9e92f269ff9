layout(location = 0) in vec3 place;
layout(location = 2) in vec4 paint;
uniform float solid;  // 1: dark all over; 0: as the colour says
out float dark;
void main() {
  dark = dark_at(place) * max(solid, paint.r) * paint.w;
  gl_Position = drawn(fall(place), 0);
}
