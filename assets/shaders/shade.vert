// The part of the ground that the maps of shadows show.
out vec2 place;
out vec2 spot;  // on a map, from 0 to 1
void main() {
  spot = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = shadow_middle + (2.0 * spot - 1.0) * shadow_reach;
  gl_Position = camera * vec4(place.x, level, place.y, 1.0);
}
