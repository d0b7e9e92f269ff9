// A triangle that just covers the ball as the eye sees it.
layout(location = 0) in vec4 ball;    // centre, radius
layout(location = 1) in vec4 paint;   // colour, style
layout(location = 2) in vec4 second;  // colour of the rim, opacity
out vec3 spot;
flat out vec4 ball_of;
flat out vec4 paint_of;
flat out vec4 second_of;
void main() {
  vec2 corner = corner_of_triangle();
  vec3 c = ball.xyz;
  float r = ball.w, d2 = max(dot(c, c), 1e-20), d = sqrt(d2);
  vec3 f = c / d;
  vec3 s = normalize(cross(f, abs(f.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  vec3 t = cross(s, f);
  float k = (d2 > 1.02 * r * r ? d * r * inversesqrt(d2 - r * r) : 8.0 * r) + margin * pixel * d;
  spot = c + (s * corner.x + t * corner.y) * k;
  ball_of = ball;
  paint_of = paint;
  second_of = second;
  gl_Position = camera * vec4(spot, 1.0);
}
