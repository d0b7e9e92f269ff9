in vec3 spot;
flat in vec4 from_of;
flat in vec4 to_of;
flat in vec4 paint_of;
out vec4 result;
void main() {
  vec3 a = from_of.xyz, along = to_of.xyz - a, ray = normalize(spot);
  float r = from_of.w;
  // Nearest approach of the line of sight to the axis.
  vec3 a_off = a - ray * dot(a, ray), along_off = along - ray * dot(along, ray);
  float off2 = dot(along_off, along_off);
  float part = off2 > 1e-18 ? clamp(-dot(a_off, along_off) / off2, 0.0, 1.0) : 0.0;
  vec3 gap = a_off + part * along_off;
  float q = r * r - dot(gap, gap);
  float alpha = coverage(q) * seen(paint_of.w);
  if (alpha < least) discard;
  // Where the line enters the capsule, from the nearest approach on.
  float start = dot(a + along * part, ray), t = entry(ray * start - a, along, ray, r, -sqrt(max(q, 0.0)));
  vec3 hit = ray * (start + t);
  vec3 axis = a + along * clamp(dot(hit - a, along) / max(dot(along, along), 1e-18), 0.0, 1.0);
  gl_FragDepth = depth_of(hit);
  result = vec4(shown(to_of.w > 0.5 ? paint_of.rgb : shade(paint_of.rgb, normalize(hit - axis), -ray)), alpha);
}
