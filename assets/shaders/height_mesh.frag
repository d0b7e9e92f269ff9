in float height;
out vec4 result;
void main() { result = vec4(height); }
