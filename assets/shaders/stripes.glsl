#ifdef FRAGMENT
// Six segments, so that a spin is seen.
vec3 painted(vec3 at, vec3 paint, vec3 second) {
  float stripe = sin(3.0 * atan(at.z, at.x)) * length(at.xz);
  float w = max(fwidth(stripe), 1e-6);
  return mix(second, paint, smoothstep(-w, w, stripe));
}
#endif
