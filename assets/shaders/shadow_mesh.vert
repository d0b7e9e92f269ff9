layout(location = 0) in vec3 place;
layout(location = 2) in vec3 paint;
uniform float solid;  // 1: dark all over; 0: as the colour says
out float dark;
void main() {
  dark = place.y < level ? 0.0 : 1.0 / (1.0 + 1.2 * (place.y - level) / size);
  dark *= max(solid, paint.r);
  gl_Position = drawn(fall(place), 0);
}
