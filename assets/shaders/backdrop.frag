in float height;
uniform vec3 low;   // sRGB
uniform vec3 high;  // sRGB
out vec4 result;
void main() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;  // hides bands
  result = vec4(mix(low, high, smoothstep(0.0, 1.0, height)) + noise / 255.0, 1.0);
}
