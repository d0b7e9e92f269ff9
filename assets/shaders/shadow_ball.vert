layout(location = 0) in vec4 ball;
out vec2 off;  // from the shadow's middle
flat out vec2 edge;  // radius, softness
void main() {
  vec2 corner = corner_of_triangle();
  vec2 middle = fall(ball.xyz);
  float height = ball.y - level, pixel = pixel_at(middle, pixels);
  edge = vec2(ball.w, softness(ball.w, height, pixel));
  off = corner * (edge.x + edge.y);
  gl_Position = height < -ball.w || edge.x < 0.03 * edge.y ? vec4(2.0) : drawn(middle + off, map_for(edge.y, pixel));
}
