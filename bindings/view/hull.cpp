#include "view/hull.hpp"

#include <algorithm>
#include <map>

namespace pantin {

namespace {

using Face = std::array<std::uint32_t, 3>;

// Index of the point with the largest value.
template <class Value>
std::uint32_t farthest(std::span<const Vec3> points, Value value) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < points.size(); i++)
    if (value(points[i]) > value(points[best])) best = i;
  return best;
}

// Four points that span a volume, or none.
std::vector<std::uint32_t> first_four(std::span<const Vec3> p, double small) {
  const std::uint32_t a = farthest(p, [&](Vec3 v) { return -v[0]; });
  const std::uint32_t b = farthest(p, [&](Vec3 v) { return norm2(v - p[a]); });
  const Vec3 line = direction(p[b] - p[a]);
  const std::uint32_t c = farthest(p, [&](Vec3 v) { return norm2(cross(line, v - p[a])); });
  const Vec3 normal = direction(cross(p[b] - p[a], p[c] - p[a]), zero3());
  const std::uint32_t d = farthest(p, [&](Vec3 v) { return std::fabs(dot(normal, v - p[a])); });
  const double height = dot(normal, p[d] - p[a]);
  if (!(std::fabs(height) > small)) return {};
  return height > 0.0 ? std::vector{a, c, b, d} : std::vector{a, b, c, d};  // d lies behind the first three
}

}  // namespace

std::vector<Face> convex_hull(std::span<const Vec3> points) {
  if (points.size() < 4) return {};
  double size = 0.0;
  for (const Vec3 p : points) size = std::max(size, largest(p - points[0]));
  const double small = 1e-7 * size;
  const auto start = first_four(points, small);
  if (start.empty()) return {};
  std::vector<Face> faces = {{start[0], start[1], start[2]},
                             {start[0], start[3], start[1]},
                             {start[1], start[3], start[2]},
                             {start[2], start[3], start[0]}};
  for (std::uint32_t i = 0; i < points.size(); i++) {
    // Faces that see the point go; the edges that only one of them had are tied to it.
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> rim;
    const auto seen = [&](const Face& f) {
      const Vec3 normal = direction(cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]), zero3());
      if (!(dot(normal, points[i] - points[f[0]]) > small)) return false;
      for (std::size_t k = 0; k < 3; k++) rim[{f[k], f[(k + 1) % 3]}] = true;
      return true;
    };
    std::erase_if(faces, seen);
    for (const auto& [edge, there] : rim)
      if (!rim.contains({edge.second, edge.first})) faces.push_back({edge.first, edge.second, i});
  }
  return faces;
}

}  // namespace pantin
