#include "structures/rings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/interruptible.hpp"

namespace pantin {
namespace {

class RingSearch {
 public:
  explicit RingSearch(const Structure& s)
      : neighbours_(s.vertices.size()), depth_(s.vertices.size(), 0), from_(depth_) {
    for (const StructureEdge& e : s.edges) {
      neighbours_[e[0]].push_back(e[1]);
      neighbours_[e[1]].push_back(e[0]);
    }
    for (auto& list : neighbours_) std::sort(list.begin(), list.end());
  }
  const std::vector<std::uint32_t>& neighbours(std::uint32_t v) const { return neighbours_[v]; }

  /// The shortest ring through a, b and c, or nothing where it is longer than `longest`.
  StructureFace shortest(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t longest) {
    std::vector<std::uint32_t> met = {b, a};
    depth_[b] = 1;
    depth_[a] = 2;
    for (std::size_t next = 1; next < met.size() && !depth_[c]; next++) {
      const std::uint32_t v = met[next];
      if (depth_[v] >= longest) break;
      loop_.count(neighbours_[v].size());
      for (std::uint32_t w : neighbours_[v]) {
        if (depth_[w]) continue;
        depth_[w] = depth_[v] + 1;
        from_[w] = v;
        met.push_back(w);
      }
    }
    StructureFace ring;
    if (depth_[c]) {
      for (std::uint32_t v = c; v != a; v = from_[v]) ring.push_back(v);
      ring.push_back(a);
      ring.push_back(b);
    }
    for (std::uint32_t v : met) depth_[v] = 0;
    return ring;
  }

 private:
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::vector<std::uint32_t> depth_;  // in the ring, from 1; 0: not met
  std::vector<std::uint32_t> from_;
  Interruptible loop_;
};

/// The lowest number first, the lower of its neighbours next.
StructureFace canonical(StructureFace ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  if (ring[1] > ring.back()) std::reverse(ring.begin() + 1, ring.end());
  return ring;
}

Vec3 normal_of(const Structure& s, const StructureFace& face) {
  const Vec3 centre = middle(s, face);
  Vec3 sum = zero3();
  for (std::size_t i = 0; i < face.size(); i++)
    sum += cross(s.vertices[face[i]] - centre, s.vertices[face[(i + 1) % face.size()]] - centre);
  return direction(sum);
}

bool is_flat(const Structure& s, const StructureFace& face, double thickness) {
  const Vec3 centre = middle(s, face), normal = normal_of(s, face);
  return std::all_of(face.begin(), face.end(),
                     [&](std::uint32_t v) { return std::fabs(dot(s.vertices[v] - centre, normal)) <= thickness; });
}

bool faces_inwards(const Structure& s, const StructureFace& face, Vec3 centre) {
  const Vec3 normal = normal_of(s, face), out = middle(s, face) - centre;
  if (std::fabs(dot(normal, out)) > 1e-3 * norm(out)) return dot(normal, out) < 0.0;
  for (int i = 0; i < 3; i++)
    if (std::fabs(normal[i]) > 1e-3) return normal[i] < 0.0;
  return false;
}

}  // namespace

std::vector<StructureFace> flat_rings(const Structure& s, std::size_t longest, double thickness) {
  RingSearch search(s);
  std::set<StructureFace> known;
  std::vector<StructureFace> rings;
  Vec3 centre = zero3();
  for (Vec3 v : s.vertices) centre += v / static_cast<double>(s.vertices.size());
  for (std::uint32_t b = 0; b < s.vertices.size(); b++) {
    const auto& around = search.neighbours(b);
    for (std::size_t i = 0; i < around.size(); i++)
      for (std::size_t j = i + 1; j < around.size(); j++) {
        StructureFace ring = search.shortest(around[i], b, around[j], longest);
        if (ring.empty() || !known.insert(ring = canonical(std::move(ring))).second) continue;
        if (!is_flat(s, ring, thickness)) continue;
        if (faces_inwards(s, ring, centre)) std::reverse(ring.begin() + 1, ring.end());
        rings.push_back(std::move(ring));
      }
  }
  return rings;
}

}  // namespace pantin
