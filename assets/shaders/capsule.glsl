#ifdef FRAGMENT
// How far along a ray it enters a capsule (after I. Quilez, capsule intersection); oa: from one end of its axis to the
// ray's start. Where it passes: `passed`.
float entry(vec3 oa, vec3 along, vec3 ray, float r, float passed) {
  float ll = max(dot(along, along), 1e-18), lr = dot(along, ray), lo = dot(along, oa), ro = dot(ray, oa);
  float qa = ll - lr * lr, qb = ll * ro - lo * lr, qc = ll * dot(oa, oa) - lo * lo - r * r * ll, h = qb * qb - qa * qc;
  vec3 oc = lr > 0.0 ? oa : oa - along;
  if (h >= 0.0 && qa > 1e-6 * ll) {
    float side = (-qb - sqrt(h)) / qa, y = lo + side * lr;
    if (y > 0.0 && y < ll) return side;
    oc = y <= 0.0 ? oa : oa - along;
  }
  float b = dot(ray, oc), inside = b * b - dot(oc, oc) + r * r;
  return inside > 0.0 ? -b - sqrt(inside) : passed;
}
#endif
