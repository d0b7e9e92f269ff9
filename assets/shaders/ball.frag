in vec3 spot;
flat in vec4 ball_of;
flat in vec4 paint_of;
flat in vec3 second_of;
out vec4 result;
void main() {
  vec3 c = ball_of.xyz, ray = normalize(spot);
  float r = ball_of.w, b = dot(ray, c);
  vec3 off = c - ray * b;
  float q = r * r - dot(off, off);
  float a = coverage(q);
  if (paint_of.w > 1.5) a = min(a, coverage(0.30 * r * r - q));  // a ring
  if (a < least) discard;
  vec3 hit = ray * (b - sqrt(max(q, 0.0)));
  vec3 n = normalize(hit - c);
  vec3 color = paint_of.rgb;
  if (paint_of.w > 1.5) {
    gl_FragDepth = 0.0;
    result = vec4(shown(color), a);
    return;
  }
  if (paint_of.w > 0.5) color = mix(second_of, color, smoothstep(0.62, 0.70, dot(n, -ray)));  // a hinge
  gl_FragDepth = depth_of(hit);
  result = vec4(shown(shade(color, n, -ray)), a);
}
