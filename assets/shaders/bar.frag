in vec3 spot;
flat in vec4 from_of;
flat in vec4 to_of;
flat in vec3 paint_of;
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
  float alpha = coverage(q);
  if (alpha < least) discard;
  // Where the line enters the capsule (after I. Quilez, capsule intersection), from the nearest approach on.
  float start = dot(a + along * part, ray), t = -sqrt(max(q, 0.0));
  vec3 oa = ray * start - a;
  float ll = max(dot(along, along), 1e-18), lr = dot(along, ray), lo = dot(along, oa), ro = dot(ray, oa);
  float qa = ll - lr * lr, qb = ll * ro - lo * lr, qc = ll * dot(oa, oa) - lo * lo - r * r * ll, h = qb * qb - qa * qc;
  if (h >= 0.0 && qa > 1e-6 * ll) {
    float side = (-qb - sqrt(h)) / qa, y = lo + side * lr;
    if (y > 0.0 && y < ll) {
      t = side;
    } else {
      vec3 oc = y <= 0.0 ? oa : oa - along;
      float b = dot(ray, oc), inside = b * b - dot(oc, oc) + r * r;
      if (inside > 0.0) t = -b - sqrt(inside);
    }
  } else {
    vec3 oc = lr > 0.0 ? oa : oa - along;
    float b = dot(ray, oc), inside = b * b - dot(oc, oc) + r * r;
    if (inside > 0.0) t = -b - sqrt(inside);
  }
  vec3 hit = ray * (start + t);
  vec3 axis = a + along * clamp(dot(hit - a, along) / ll, 0.0, 1.0);
  gl_FragDepth = depth_of(hit);
  result = vec4(shown(to_of.w > 0.5 ? paint_of : shade(paint_of, normalize(hit - axis), -ray)), alpha);
}
