#include "shapes/way.hpp"

#include <algorithm>

#include "shapes/mesh_tree.hpp"

namespace pantin {

namespace {

/// The earliest so far.
struct Earliest {
  std::optional<RayHit> hit;
  std::uint32_t index = 0;

  double part() const { return hit ? hit->part : 1.0; }
  void offer(const std::optional<RayHit>& other, std::uint32_t of) {
    if (!other || (hit && (other->part > hit->part || (other->part == hit->part && of > index)))) return;
    hit = other;
    index = of;
  }
};

/// The parts of a way that are within bounds; empty where low > high.
struct Parts {
  double low = 0.0, high = 1.0;
};

Parts parts_within(const Way& way, const Bounds& bounds) {
  Parts parts;
  for (int i = 0; i < 3; i++) {
    const double low = bounds.low[i] - way.half[i] - way.from[i], high = bounds.high[i] + way.half[i] - way.from[i];
    if (way.along[i] == 0.0) {
      if (low > 0.0 || high < 0.0) return {1.0, 0.0};
      continue;
    }
    const double one = low / way.along[i], other = high / way.along[i], slack = 1e-12;
    parts.low = std::max(parts.low, std::min(one, other) - slack);
    parts.high = std::min(parts.high, std::max(one, other) + slack);
  }
  return parts;
}

}  // namespace

bool meets(const Way& way, const Bounds& bounds, double before) {
  const Parts parts = parts_within(way, bounds);
  return parts.low <= parts.high && parts.low <= before;
}

std::optional<RayHit> first_met(const TriangleMesh& mesh, const Way& way, const MeetTriangle& meet) {
  Earliest earliest;
  walk_tree(
      mesh, [&](const Bounds& bounds) { return meets(way, bounds, earliest.part()); },
      [&](std::uint32_t index) { earliest.offer(meet(triangle_of(mesh, index)), index); });
  return earliest.hit;
}

std::optional<RayHit> first_met(const HeightField& field, const Way& way, const MeetTriangle& meet) {
  const double x = 0.5 * field.spacing * (field.columns - 1), z = 0.5 * field.spacing * (field.rows - 1);
  const Parts parts = parts_within(way, {vec(-x, field.lowest, -z), vec(x, field.highest, z)});
  if (parts.low > parts.high) return {};
  const double cells = std::max(std::fabs(way.along[0]), std::fabs(way.along[2])) * (parts.high - parts.low) /
                       (field.spacing + 2.0 * std::max(way.half[0], way.half[2]));
  const double pieces = std::floor(cells) + 1.0, step = (parts.high - parts.low) / pieces;
  Earliest earliest;
  for (double piece = 0.0; piece < pieces && !(earliest.hit && earliest.part() <= parts.low + piece * step); piece++) {
    const Vec3 begin = way.from + way.along * (parts.low + piece * step), end = begin + way.along * step;
    const Vec3 wide = way.half + vec(1, 1, 1) * (1e-12 * (largest(begin) + largest(end)));
    const Bounds box{(begin < end ? begin : end) - wide, (begin < end ? end : begin) + wide};
    triangles_in(field, box, [&](const MeshTriangle& triangle) { earliest.offer(meet(triangle), triangle.index); });
  }
  return earliest.hit;
}

std::optional<MeshTriangle> triangle_above(const HeightField& field, Vec3 point) {
  std::optional<MeshTriangle> above;
  const Bounds column{vec(point[0], -infinity, point[2]), vec(point[0], infinity, point[2])};
  triangles_in(field, column, [&](const MeshTriangle& triangle) {
    for (std::size_t i = 0; i < 3; i++) {
      const Vec3 edge = triangle.corner[(i + 1) % 3] - triangle.corner[i], to = point - triangle.corner[i];
      if (edge[2] * to[0] - edge[0] * to[2] < 0.0) return;
    }
    if (!above && dot(triangle.normal, point - triangle.corner[0]) <= 0.0) above = triangle;
  });
  return above;
}

}  // namespace pantin
