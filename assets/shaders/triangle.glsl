#ifndef FRAGMENT
// Corners of a triangle round the circle of radius 1: less to fill than a square, of two triangles.
vec2 corner_of_triangle() {
  return gl_VertexID == 0 ? vec2(0.0, 2.0) : vec2(gl_VertexID == 1 ? -1.7320509 : 1.7320509, -1.0);
}
#endif
