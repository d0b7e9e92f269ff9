in float dark;
in vec2 at_of;
uniform sampler2D picture;
out vec4 result;
void main() {
  if (texture(picture, at_of).a < 0.5) discard;
  result = vec4(dark);
}
