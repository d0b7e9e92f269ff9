// The ground fades towards its edge.
uniform float level;   // its height
uniform vec2 middle;   // of the drawn part
uniform float reach;   // its radius
uniform float strength;  // of all on it, 0 … 1
float fade_at(vec2 place) {
  vec2 off = place - middle;
  return max(1.0 - dot(off, off) * (1.0 / (reach * reach)), 0.0);
}
