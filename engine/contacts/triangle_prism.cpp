#include "contacts/triangle_prism.hpp"

namespace pantin {

TrianglePrism::TrianglePrism() : hull_(std::make_shared<Hull>()), geometry_(std::shared_ptr<const Hull>(hull_)) {
  Hull& h = *hull_;
  h.vertices.resize(6);
  h.packs.resize(6);
  h.loops = {0, 1, 2};
  h.faces = {{zero3(), 0.0, 0, 3}};
  for (std::uint32_t i = 0; i < 3; i++) {
    const std::uint32_t j = (i + 1) % 3;
    h.faces.push_back({zero3(), 0.0, static_cast<std::uint32_t>(h.loops.size()), 4});
    h.loops.insert(h.loops.end(), {j, i, i + 3, j + 3});
  }
  h.faces.push_back({zero3(), 0.0, static_cast<std::uint32_t>(h.loops.size()), 3});
  h.loops.insert(h.loops.end(), {3, 5, 4});
  for (std::uint32_t i = 0; i < 3; i++) {
    const std::uint32_t j = (i + 1) % 3, before = (i + 2) % 3;
    h.edges.insert(h.edges.end(), {{i, j}, {i + 3, j + 3}, {i, i + 3}});
    h.edge_faces.insert(h.edge_faces.end(), {{0, 1 + i}, {1 + i, 4}, {1 + before, 1 + i}});
  }
}

void TrianglePrism::set(const std::array<Vec3, 3>& corner, Vec3 normal, double depth) {
  Hull& h = *hull_;
  h.reach = 0.0;
  for (std::uint32_t i = 0; i < 3; i++) {
    h.vertices[i] = corner[i];
    h.vertices[i + 3] = corner[i] - normal * depth;
    h.reach = std::fmax(h.reach, std::fmax(norm(h.vertices[i]), norm(h.vertices[i + 3])));
  }
  h.thickness = depth;
  h.faces[0].normal = normal;
  h.faces[4].normal = -normal;
  for (std::uint32_t i = 0; i < 3; i++)
    h.faces[1 + i].normal = direction(cross(corner[(i + 1) % 3] - corner[i], normal));
  for (Hull::Face& face : h.faces) face.offset = dot(face.normal, h.vertices[h.loops[face.first]]);
  for (std::uint32_t pack = 0; pack < 2; pack++)
    for (std::uint32_t i = 0; i < 4; i++)
      for (std::uint32_t k = 0; k < 3; k++) h.packs[3 * pack + k][i] = h.vertices[std::min(4 * pack + i, 5u)][k];
}

}  // namespace pantin
