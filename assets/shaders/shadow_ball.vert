layout(location = 0) in vec4 ball;
layout(location = 2) in vec4 second;  // its opacity at the end
out vec2 off;  // from the shadow's middle
flat out vec3 edge;  // radius, softness, opacity
void main() {
  vec2 corner = corner_of_triangle();
  vec2 middle = fall(ball.xyz);
  float height = ball.y - level, pixel = pixel_at(middle, pixels);
  edge = vec3(ball.w, softness(ball.w, height, pixel), second.w);
  off = corner * (edge.x + edge.y);
  gl_Position = height < -ball.w || edge.x < 0.03 * edge.y ? vec4(2.0) : drawn(middle + off, map_for(edge.y, pixel));
}
