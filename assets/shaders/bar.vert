// A box round a capsule; its back faces are drawn, so the eye may be inside.
layout(location = 0) in vec4 from;   // one end, radius
layout(location = 1) in vec4 to;     // other end, style
layout(location = 2) in vec3 paint;
out vec3 spot;
flat out vec4 from_of;
flat out vec4 to_of;
flat out vec3 paint_of;
const int corners[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3,
                                5, 3, 7, 5);
void main() {
  int corner = corners[gl_VertexID];
  vec3 side = vec3(corner & 1, (corner >> 1) & 1, corner >> 2) * 2.0 - 1.0;
  vec3 along = to.xyz - from.xyz;
  float length_of = length(along);
  vec3 u = length_of > 0.0 ? along / length_of : vec3(1, 0, 0);
  vec3 s = normalize(cross(u, abs(u.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 t = cross(u, s);
  vec3 middle = 0.5 * (from.xyz + to.xyz);
  float pad = from.w + pixel * (length(middle) + length_of);
  spot = middle + u * side.x * (0.5 * length_of + pad) + (s * side.y + t * side.z) * pad;
  from_of = from;
  to_of = to;
  paint_of = paint;
  gl_Position = camera * vec4(spot, 1.0);
}
