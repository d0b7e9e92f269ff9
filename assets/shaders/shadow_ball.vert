layout(location = 0) in vec4 ball;
out vec2 off;  // from the shadow's middle
flat out vec2 edge;  // radius, softness
void main() {
  vec2 corner = corner_of_triangle();
  float height = ball.y - level;
  edge = vec2(ball.w, softness(ball.w, height));
  off = corner * (edge.x + edge.y);
  gl_Position = height < -ball.w || edge.x < 0.03 * edge.y ? vec4(2.0) : drawn(fall(ball.xyz) + off, map_for(edge.y));
}
