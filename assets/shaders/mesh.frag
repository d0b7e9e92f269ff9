in vec3 spot;
in vec3 normal_at;
in vec3 paint_at;
out vec4 result;
void main() { result = vec4(shown(shade(paint_at, normalize(normal_at), -normalize(spot))), 1.0); }
