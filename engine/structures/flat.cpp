#include "structures/flat.hpp"

#include <cmath>

namespace pantin {

void move_to_middle(Structure& s) {
  Vec3 low = s.vertices[0], high = low;
  for (Vec3 v : s.vertices)
    for (int i = 0; i < 3; i++) {
      low[i] = std::fmin(low[i], v[i]);
      high[i] = std::fmax(high[i], v[i]);
    }
  for (Vec3& v : s.vertices) v -= (low + high) / 2.0;
}

void add_flat_faces(Structure& s) {
  for (StructureFace& face : traced_faces(s, [](std::uint32_t) { return vec(0, 0, 1); })) {
    double doubled_area = 0.0;
    for (std::size_t i = 0; i < face.size(); i++)
      doubled_area += cross(s.vertices[face[i]], s.vertices[face[(i + 1) % face.size()]])[2];
    if (doubled_area > 0.0) s.faces.push_back(std::move(face));
  }
}

}  // namespace pantin
