// A strip that faces the eye, from the tail of a streak to its head.
layout(location = 0) in vec4 head;   // place, half width
layout(location = 1) in vec3 tail;
layout(location = 2) in vec4 paint;  // colour as shown, opacity
out vec2 place;
flat out vec4 paint_of;
void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 along = head.xyz - tail;
  float length_of = length(along);
  vec3 u = length_of > 0.0 ? along / length_of : vec3(0, 1, 0);
  vec3 side = cross(u, normalize(head.xyz));
  float sine = length(side);
  side = sine > 1e-6 ? side / sine : vec3(0);
  vec3 end = place.y > 0.0 ? head.xyz + u * head.w : tail - u * head.w;
  paint_of = paint;
  gl_Position = camera * vec4(end + side * (place.x * head.w), 1.0);
}
