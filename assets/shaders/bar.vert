// A box round a capsule; its back faces are drawn, so the eye may be inside.
layout(location = 0) in vec4 from;   // one end, radius
layout(location = 1) in vec4 to;     // other end, style
layout(location = 2) in vec4 paint;  // colour, opacity
out vec3 spot;
flat out vec4 from_of;
flat out vec4 to_of;
flat out vec4 paint_of;
void main() {
  int bit = 1 << gl_VertexID;  // the corners of a box as one strip of 14
  vec3 side = vec3((0x287a & bit) != 0, (0x02af & bit) != 0, (0x31e3 & bit) != 0) * 2.0 - 1.0;
  vec3 along = to.xyz - from.xyz;
  float length_of = length(along);
  vec3 u = length_of > 0.0 ? along / length_of : vec3(1, 0, 0);
  vec3 s = normalize(cross(u, abs(u.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 t = cross(u, s);
  vec3 middle = 0.5 * (from.xyz + to.xyz);
  float pad = from.w + margin * pixel * (length(middle) + length_of);
  spot = middle + u * side.x * (0.5 * length_of + pad) + (s * side.y + t * side.z) * pad;
  from_of = from;
  to_of = to;
  paint_of = paint;
  gl_Position = camera * vec4(spot, 1.0);
}
