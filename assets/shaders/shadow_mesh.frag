in float dark;
out vec4 result;
void main() { result = vec4(dark); }
