#ifdef FRAGMENT
uniform sampler2D picture;  // its colours times their opacity
vec3 opaque(vec4 texel) {
  vec3 color = texel.rgb / max(texel.a, 1e-3);
  return color * color;
}
// A colour where a picture is on it.
vec3 pictured(vec3 paint, vec4 texel) { return paint * mix(vec3(1.0), opaque(texel), texel.a); }
#endif
