#include <algorithm>

#include "base/check.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"

namespace pantin {

namespace {

void sound_shape(bool good) { require(good, "a shape in it contradicts itself"); }

template <class List>
bool all_below(const List& list, std::size_t size) {
  return std::all_of(list.begin(), list.end(), [&](std::uint32_t i) { return i < size; });
}

}  // namespace

void check_read(const Hull& hull) {
  sound_shape(hull.vertices.size() >= 3 && !hull.faces.empty() && !hull.edges.empty() &&
              hull.edge_faces.size() == hull.edges.size() && hull.packs.size() == 3 * ((hull.vertices.size() + 3) / 4));
  sound_shape(all_below(hull.loops, hull.vertices.size()));
  for (const Hull::Face& face : hull.faces)
    sound_shape(face.first <= hull.loops.size() && face.count >= 3 && face.count <= hull.loops.size() - face.first);
  for (const auto& edge : hull.edges) sound_shape(all_below(edge, hull.vertices.size()));
  for (const auto& faces : hull.edge_faces) sound_shape(all_below(faces, hull.faces.size()));
}

void check_read(const TriangleMesh& mesh) {
  const auto triangles = static_cast<std::int32_t>(mesh.triangles.size());
  sound_shape(!mesh.triangles.empty() && !mesh.tree.empty() && all_below(mesh.order, mesh.triangles.size()));
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    sound_shape(all_below(t.corner, mesh.vertices.size()));
    for (const std::int32_t n : t.neighbour) sound_shape(n >= -1 && n < triangles);
  }
  for (std::size_t k = 0; k < mesh.tree.size(); k++) {
    const TriangleMesh::Branch& b = mesh.tree[k];
    sound_shape(b.count > 0 ? b.first <= mesh.order.size() && b.count <= mesh.order.size() - b.first
                            : b.first > k && b.first < mesh.tree.size() - 1);
  }
}

void check_read(const HeightField& field) {
  sound_shape(field.columns >= 2 && field.rows >= 2 && field.spacing > 0.0 &&
              field.heights.size() == std::size_t{field.columns} * field.rows);
}

}  // namespace pantin
