layout(location = 0) in vec4 ball;
layout(location = 2) in vec4 second;  // its opacity at the end
out vec3 off;  // from its centre, at its height
flat out float radius;
flat out float height;
void main() {
  vec2 corner = corner_of_triangle() * ball.w, u = length(light.xz) > 0.0 ? normalize(light.xz) : vec2(1, 0);
  vec2 at = u * corner.x / light.y + vec2(-u.y, u.x) * corner.y;
  off = vec3(at.x, 0.0, at.y);
  radius = ball.w;
  height = ball.y - level;
  gl_Position = second.w < 1.0 ? vec4(2.0) : drawn(fall(ball.xyz) + at);
}
