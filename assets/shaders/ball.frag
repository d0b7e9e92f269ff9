in vec3 spot;
flat in vec4 ball_of;
flat in vec4 paint_of;
flat in vec4 second_of;
out vec4 result;
void main() {
  vec3 c = ball_of.xyz, ray = normalize(spot);
  float r = ball_of.w, b = dot(ray, c);
  vec3 off = c - ray * b;
  float q = r * r - dot(off, off), a = coverage(q) * seen(second_of.w);
  if (a < least) discard;
  vec3 hit = ray * (b - sqrt(max(q, 0.0))), n = normalize(hit - c);
  // A hinge has a rim.
  vec3 color = mix(paint_of.rgb, second_of.rgb, paint_of.w * (1.0 - smoothstep(0.62, 0.70, dot(n, -ray))));
  gl_FragDepth = depth_of(hit);
  result = vec4(shown(shade(color, n, -ray)), a);
}
