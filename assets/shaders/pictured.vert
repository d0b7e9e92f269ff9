layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 paint;  // colour, opacity
layout(location = 3) in vec2 at;  // on the picture
out vec3 spot;
out vec3 normal_at;
out vec4 paint_at;
out vec2 at_of;
void main() {
  spot = place;
  normal_at = normal;
  paint_at = paint;
  at_of = at;
  gl_Position = camera * vec4(place, 1.0);
}
