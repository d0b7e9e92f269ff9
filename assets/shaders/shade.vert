// The part of the ground that the maps of shadows show.
uniform vec2 corners[4];
out vec2 place;
void main() {
  place = corners[gl_VertexID];
  gl_Position = camera * vec4(place.x, level, place.y, 1.0);
}
