// Edges of round things: soft where there are samples.
const float least = sampled ? 1.0 / 256.0 : 0.5;  // opacity that is drawn
const float margin = sampled ? 1.0 : 0.0;         // [px] by which the soft edge sticks out
#ifdef FRAGMENT
// Opacity at an edge where q falls through 0; one pixel wide if soft.
float coverage(float q) { return sampled ? clamp(q / max(fwidth(q), 1e-20) + 0.5, 0.0, 1.0) : step(0.0, q); }
#endif
