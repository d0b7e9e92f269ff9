in vec3 off;
flat in mat3 inward;
flat in float height;
out vec4 result;
void main() {
  vec3 d = inward * light, o = inward * off;
  float dd = dot(d, d), b = -dot(o, d) / dd, q = 1.0 - dot(o, o) + b * b * dd;
  if (q < 0.0) discard;
  result = vec4(height + (b + sqrt(q / dd)) * light.y);
}
