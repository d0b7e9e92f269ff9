#include "view/hull.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

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

// Quickhull (Barber, Dobkin and Huhdanpaa 1996). What is replaced at once hangs together, so each point adds two faces at
// most, however the signs of flat ones come out.
class HullMaker {
 public:
  HullMaker(std::span<const Vec3> points, double small) : points_(points), small_(small) {
    const auto start = first_four(points, small);
    if (start.empty()) return;
    const std::uint32_t first[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    for (const auto& f : first) add(start[f[0]], start[f[1]], start[f[2]]);
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0u);
    share(all, 0);
    for (std::size_t i = 0; i < facets_.size(); i++)
      if (facets_[i].there && !facets_[i].outside.empty()) reach_out(i);
  }
  std::vector<Face> faces() const {
    std::vector<Face> list;
    for (const Facet& f : facets_)
      if (f.there) list.push_back(f.corners);
    return list;
  }

 private:
  struct Facet {
    Face corners;
    Vec3 normal;
    std::vector<std::uint32_t> outside;  // points that it sees; each belongs to one facet
    bool there = true;
  };

  static std::uint64_t edge(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32u | to; }
  double height(const Facet& f, std::uint32_t i) const { return dot(f.normal, points_[i] - points_[f.corners[0]]); }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3 ab = points_[b] - points_[a], ac = points_[c] - points_[a], twice = cross(ab, ac);
    const double longest = std::sqrt(std::max({norm2(ab), norm2(ac), norm2(ac - ab)}));
    // A needle has no side from which anything is seen.
    const Vec3 normal = norm(twice) > 1e-3 * small_ * longest ? direction(twice) : zero3();
    const auto index = static_cast<std::uint32_t>(facets_.size());
    facets_.push_back({{a, b, c}, normal, {}});
    sides_[edge(a, b)] = sides_[edge(b, c)] = sides_[edge(c, a)] = index;
  }
  // Gives the points to the facets from `first` on that see them.
  void share(const std::vector<std::uint32_t>& list, std::size_t first) {
    for (const std::uint32_t i : list)
      for (std::size_t f = first; f < facets_.size(); f++)
        if (height(facets_[f], i) > small_) {
          facets_[f].outside.push_back(i);
          break;
        }
  }
  // Replaces the facets round this one that see the farthest of its points by a cone to that point.
  void reach_out(std::size_t index) {
    const Facet& from = facets_[index];
    const std::uint32_t top =
        *std::ranges::max_element(from.outside, {}, [&](std::uint32_t i) { return height(from, i); });
    std::vector<std::size_t> seen = {index};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rim;
    std::vector<std::uint32_t> orphans;
    facets_[index].there = false;
    for (std::size_t k = 0; k < seen.size(); k++) {
      Facet& f = facets_[seen[k]];
      orphans.insert(orphans.end(), f.outside.begin(), f.outside.end());
      f.outside.clear();
      for (std::size_t n = 0; n < 3; n++) {
        const std::uint32_t a = f.corners[n], b = f.corners[(n + 1) % 3], next = sides_.at(edge(b, a));
        if (facets_[next].there && height(facets_[next], top) > small_) {
          facets_[next].there = false;
          seen.push_back(next);
        } else if (facets_[next].there) {
          rim.emplace_back(a, b);
        }
      }
    }
    const std::size_t first = facets_.size();
    for (const auto& [a, b] : rim) add(a, b, top);
    share(orphans, first);
  }

  std::span<const Vec3> points_;
  double small_;
  std::vector<Facet> facets_;
  std::unordered_map<std::uint64_t, std::uint32_t> sides_;  // the facet at the left of an edge
};

}  // namespace

std::vector<Face> convex_hull(std::span<const Vec3> points) {
  if (points.size() < 4) return {};
  double size = 0.0;
  for (const Vec3 p : points) size = std::max(size, largest(p - points[0]));
  return HullMaker(points, 1e-7 * size).faces();
}

}  // namespace pantin
