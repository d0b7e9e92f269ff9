#include "shapes/cut.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "base/interruptible.hpp"

namespace pantin {

using HullPtr = std::shared_ptr<const Hull>;

namespace {

constexpr int sides = 48, meridians = 24, circles = 11;

/// Corners on a circle about the z axis.
void add_circle(std::vector<Vec3>& corners, double radius, double z, int count) {
  for (int i = 0; i < count; i++) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    corners.push_back(vec(radius * functions::cos(angle), radius * functions::sin(angle), z));
  }
}

/// Those of a ball whose halves are apart by 2 `half`.
HullPtr round_hull(double radius, double half) {
  std::vector<Vec3> corners = {vec(0, 0, half + radius), vec(0, 0, -half - radius)};
  for (int k = 1; k <= circles; k++) {
    const double angle = std::numbers::pi * k / (circles + 1);
    const int side = (circles + 1) / 2 - k;  // 0: the one about the middle
    const double r = radius * functions::sin(angle), z = side == 0 ? 0.0 : radius * functions::cos(angle);
    if (side >= 0) add_circle(corners, r, z + half, meridians);
    if (side < 0 || (side == 0 && half > 0.0)) add_circle(corners, r, z - half, meridians);
  }
  return make_hull(corners);
}

struct AsHull {
  HullPtr operator()(const BallShape& s) const { return round_hull(s.radius, 0.0); }
  HullPtr operator()(const CapsuleShape& s) const { return round_hull(s.radius, s.half); }
  HullPtr operator()(const BoxShape& s) const {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; i++)
      corners.push_back(s.half * vec((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0));
    return make_hull(corners);
  }
  HullPtr operator()(const CylinderShape& s) const {
    std::vector<Vec3> corners;
    for (const double z : {s.half, -s.half}) add_circle(corners, s.radius, z, sides);
    return make_hull(corners);
  }
  HullPtr operator()(const HullPtr& hull) const { return hull; }
  HullPtr operator()(const HalfSpaceShape&) const { return nullptr; }
  HullPtr operator()(const std::shared_ptr<const TriangleMesh>&) const { return nullptr; }
  HullPtr operator()(const std::shared_ptr<const HeightField>&) const { return nullptr; }
};

}  // namespace

HullPtr polyhedron_of(const Geometry& shape) { return std::visit(AsHull{}, shape); }

HullPtr behind(const HullPtr& hull, Vec3 normal, double offset) {
  const double near = 1e-12 * (hull->reach + std::fabs(offset));
  std::vector<double> height;
  std::vector<Vec3> corners;
  bool above = false, below = false;
  for (const Vec3 v : hull->vertices) {
    height.push_back(dot(normal, v) - offset);
    above = above || height.back() > near;
    below = below || height.back() < -near;
    if (height.back() <= near) corners.push_back(v);
  }
  if (!below) return nullptr;
  if (!above) return hull;
  for (const auto& [a, b] : hull->edges) {
    const double from = height[a], to = height[b];
    if (std::fabs(from) <= near || std::fabs(to) <= near || (from > 0.0) == (to > 0.0)) continue;
    corners.push_back(hull->vertices[a] + (hull->vertices[b] - hull->vertices[a]) * (from / (from - to)));
  }
  try {
    return make_hull(corners);
  } catch (const GivenUp&) { throw; } catch (const Error&) {
    return nullptr;
  }
}

namespace {

/// [m] from a position to the farthest corner.
double farthest_corner(const Hull& hull, Vec3 from) {
  double most = 0.0;
  for (const Vec3 v : hull.vertices) most = std::max(most, norm(v - from));
  return most;
}

HullPtr cell_of(HullPtr cell, std::span<const Vec3> sites, std::size_t own) {
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 0; i < sites.size(); i++)
    if (i != own) others.emplace_back(norm(sites[i] - sites[own]), i);
  std::sort(others.begin(), others.end());
  double reach = farthest_corner(*cell, sites[own]);
  for (const auto& [distance, other] : others) {
    if (distance > 2.0 * reach) break;
    const Vec3 normal = direction(sites[other] - sites[own]);
    const HullPtr rest = behind(cell, normal, dot(normal, (sites[own] + sites[other]) * 0.5));
    if (!rest) return nullptr;
    if (rest == cell) continue;
    cell = rest;
    reach = farthest_corner(*cell, sites[own]);
  }
  return cell;
}

}  // namespace

std::vector<HullPtr> voronoi_cells(const HullPtr& hull, std::span<const Vec3> sites) {
  std::vector<HullPtr> cells;
  for (std::size_t i = 0; i < sites.size(); i++) cells.push_back(cell_of(hull, sites, i));
  return cells;
}

}  // namespace pantin
