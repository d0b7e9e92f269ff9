in vec3 spot;
flat in vec3 centre_of;
flat in mat3 inward;
flat in vec3 paint_of;
flat in vec4 second_of;
out vec4 result;
void main() {
  vec3 ray = normalize(spot), d = inward * ray, c = inward * centre_of;
  float dd = dot(d, d), t = dot(d, c) / dd;
  vec3 off = c - d * t;
  float q = 1.0 - dot(off, off);
  float a = coverage(q) * seen(second_of.w);
  if (a < least) discard;
  float at = t - sqrt(max(q, 0.0) / dd);
  vec3 p = d * at - c;
  vec3 n = normalize(transpose(inward) * p);
  vec3 color = painted(p, paint_of, second_of.rgb);
  vec3 hit = ray * at;
  gl_FragDepth = depth_of(hit);
  result = vec4(shown(shade(color, n, -ray)), a);
}
