layout(location = 0) in vec3 centre;
layout(location = 1) in vec3 axis_x;
layout(location = 2) in vec3 axis_y;
layout(location = 3) in vec3 axis_z;
layout(location = 5) in vec4 second;  // its opacity at the end
out vec3 off;  // from its centre, at its height
flat out mat3 inward;
flat out float height;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0, slant = light.xz / light.y;
  vec2 a = axis_x.xz - slant * axis_x.y, b = axis_y.xz - slant * axis_y.y, c = axis_z.xz - slant * axis_z.y;
  vec2 at = corner * sqrt(a * a + b * b + c * c);
  off = vec3(at.x, 0.0, at.y);
  inward = inverse(mat3(axis_x, axis_y, axis_z));
  height = centre.y - level;
  gl_Position = second.w < 1.0 ? vec4(2.0) : drawn(fall(centre) + at);
}
