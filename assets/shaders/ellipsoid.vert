layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 axis_x;  // half axes
layout(location = 2) in vec3 axis_y;  // the axis of the stripes
layout(location = 3) in vec3 axis_z;
layout(location = 4) in vec3 paint;
layout(location = 5) in vec4 second;  // and opacity
out vec3 spot;
flat out vec3 centre_of;
flat out mat3 inward;  // to the space in which the ellipsoid is a ball of radius 1
flat out vec3 paint_of;
flat out vec4 second_of;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float r2 = max(dot(axis_x, axis_x), max(dot(axis_y, axis_y), dot(axis_z, axis_z)));
  float d2 = max(dot(centre, centre), 1e-20), d = sqrt(d2);
  vec3 f = centre / d;
  vec3 s = normalize(cross(f, abs(f.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 t = cross(s, f);
  float k = (d2 > 1.02 * r2 ? d * sqrt(r2 / (d2 - r2)) : 8.0 * sqrt(r2)) + margin * pixel * d;
  spot = centre + (s * corner.x + t * corner.y) * k;
  centre_of = centre;
  inward = inverse(mat3(axis_x, axis_y, axis_z));
  paint_of = paint;
  second_of = second;
  gl_Position = camera * vec4(spot, 1.0);
}
