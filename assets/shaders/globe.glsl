#ifdef FRAGMENT
// A picture round a ball, its middle towards z; `second` has how often it is there along the equator and down.
vec3 painted(vec3 at, vec3 paint, vec3 second) {
  // Angles that jump at the back and at the front: of both, the one that is smooth here.
  float turn = atan(at.x, at.z) / 6.2831853, other = fract(turn + 1.0);
  if (fwidth(other) + 0.25 < fwidth(turn)) turn = other;
  return pictured(paint, texture(picture, vec2(turn + 0.5, acos(clamp(at.y / length(at), -1.0, 1.0)) / 3.1415927) * second.xy));
}
#endif
