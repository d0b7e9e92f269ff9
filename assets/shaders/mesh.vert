layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 paint;  // colour, opacity
out vec3 spot;
out vec3 normal_at;
out vec4 paint_at;
void main() {
  spot = place;
  normal_at = normal;
  paint_at = paint;
  gl_Position = camera * vec4(place, 1.0);
}
