in vec3 off;
flat in float radius;
flat in float height;
out vec4 result;
void main() {
  float b = -dot(off, light), q = radius * radius - dot(off, off) + b * b;
  if (q < 0.0) discard;
  result = vec4(height + (b + sqrt(q)) * light.y);
}
