#ifdef FRAGMENT
// What is seen through leaves out pixels of each 4 x 4, or some samples of them, so that nothing has to be sorted.
float seen(float opacity) {
  if (opacity <= 0.0 || opacity >= 1.0) return opacity;
  ivec2 at = ivec2(gl_FragCoord.xy), odd = ivec2(at.x ^ at.y, at.y);
  int rank = (odd.x & 1) << 3 | (odd.y & 1) << 2 | (odd.x & 2) | (odd.y & 2) >> 1;  // B. Bayer, 1973
  float limit = (float(rank) + 0.5) / 16.0;
  if (!sampled) return step(limit, opacity);
  float drawn = floor(opacity * float(samples) + limit);
  return clamp((drawn - 0.4) / float(samples), 0.0, 1.0);  // so many, however a driver rounds
}
#endif
