// A convex shape on a half space: its lowest points.
#include <algorithm>
#include <vector>

#include "contacts/features.hpp"
#include "contacts/manifold_parts.hpp"
#include "shapes/hull.hpp"

namespace pantin {

namespace {

/// Part of the size within which gaps are equal.
constexpr double same_height = 1e-9;
/// Sine of the tilt above which a standing cylinder has a lowest point.
constexpr double level = 1e-7;

struct Lowest {
  const Pose& at_a;
  Vec3 normal;    ///< world
  Vec3 up;        ///< the same in the shape's own axes
  double height;  ///< [m] of the shape's origin
  double margin;  ///< [m]
  std::vector<ManifoldPoint>& points;

  double gap_of(Vec3 local) const { return height + dot(up, local); }
  void add(Vec3 local, std::uint32_t id) const {
    const double gap = gap_of(local);
    if (gap <= margin) points.push_back({at_a.to_world(local), normal, gap, id});
  }
};

void add_lowest(const Lowest& plane, const BallShape& ball) { plane.add(-plane.up * ball.radius, 0); }

/// The lowest point of the lower end; of the other end, unless it stands, that of the line along its side.
void add_lowest(const Lowest& plane, const CapsuleShape& capsule) {
  const Vec3 up = plane.up, lower_end = vec(0, 0, up[2] > 0.0 ? -capsule.half : capsule.half);
  const std::uint32_t lower = up[2] > 0.0 ? 0 : 1;
  plane.add(lower_end - up * capsule.radius, lower);
  const double across = std::sqrt(up[0] * up[0] + up[1] * up[1]);
  if (across > std::fabs(up[2])) plane.add(-lower_end - vec(up[0], up[1], 0.0) * (capsule.radius / across), 1 - lower);
}

/// Four corners, of equally low ones those of the smallest number.
void add_lowest(const Lowest& plane, const BoxShape& box) {
  std::array<Vec3, 8> corner;
  std::array<double, 8> gap;
  for (std::uint32_t i = 0; i < 8; i++) {
    const Vec3 h = box.half;
    corner[i] = vec((i & 1u) != 0 ? h[0] : -h[0], (i & 2u) != 0 ? h[1] : -h[1], (i & 4u) != 0 ? h[2] : -h[2]);
    gap[i] = plane.gap_of(corner[i]);
  }
  const double same = same_height * largest(box.half);
  for (int told = 0; told < 4; told++) {
    std::uint32_t lowest = 0;
    for (std::uint32_t i = 1; i < 8; i++)
      if (gap[i] < gap[lowest] - same) lowest = i;
    plane.add(corner[lowest], lowest);
    gap[lowest] = infinity;
  }
}

/// Standing, four points of the lower rim a quarter of a turn apart, of which the lowest of all takes the place of the one
/// nearest to it; lying, both ends of its lowest line.
void add_lowest(const Lowest& plane, const CylinderShape& cylinder) {
  const double tilt = std::sqrt(plane.up[0] * plane.up[0] + plane.up[1] * plane.up[1]);
  const Vec3 down = tilt > 0.0 ? vec(-plane.up[0], -plane.up[1], 0.0) / tilt : zero3();
  const double radius = cylinder.radius, half = cylinder.half;
  if (radius * tilt > half * std::fabs(plane.up[2])) {
    plane.add(down * radius - vec(0, 0, half), 8);
    plane.add(down * radius + vec(0, 0, half), 9);
    return;
  }
  const std::uint32_t cap = plane.up[2] < 0.0 ? 4 : 0;
  const Vec3 centre = vec(0, 0, cap == 4 ? half : -half);
  const std::array<Vec3, 4> rim = {vec(1, 0, 0), vec(0, 1, 0), vec(-1, 0, 0), vec(0, -1, 0)};
  std::uint32_t nearest = 0;
  for (std::uint32_t i = 1; i < 4; i++)
    if (dot(rim[i], down) > dot(rim[nearest], down)) nearest = i;
  for (std::uint32_t i = 0; i < 4; i++)
    if (i == nearest && tilt > level)
      plane.add(centre + down * radius, cap + (tilt > lies_on_end ? 10 : i));
    else
      plane.add(centre + rim[i] * radius, cap + i);
}

/// All corners as low as the lowest, and those of the face that looks down.
void add_lowest(const Lowest& plane, const std::shared_ptr<const Hull>& hull) {
  const double lowest = plane.gap_of(hull->vertices[farthest(*hull, -plane.up)]);
  if (lowest > plane.margin) return;
  const double low = lowest + as_low * hull->reach;
  for (std::uint32_t i = 0; i < hull->vertices.size(); i++)
    if (plane.gap_of(hull->vertices[i]) <= low) plane.add(hull->vertices[i], i);

  const auto looks_less_down = [&](const Hull::Face& f, const Hull::Face& g) {
    return dot(f.normal, plane.up) > dot(g.normal, plane.up) + same_height;
  };
  const Hull::Face& face = *std::max_element(hull->faces.begin(), hull->faces.end(), looks_less_down);
  for (std::uint32_t k = 0; k < face.count; k++) {
    const std::uint32_t i = hull->loops[face.first + k];
    if (plane.gap_of(hull->vertices[i]) > low) plane.add(hull->vertices[i], i);
  }
}

void add_lowest(const Lowest&, const HalfSpaceShape&) {}
void add_lowest(const Lowest&, const std::shared_ptr<const TriangleMesh>&) {}
void add_lowest(const Lowest&, const std::shared_ptr<const HeightField>&) {}

}  // namespace

void convex_on_plane(const Geometry& a, const Pose& at_a, const Pose& at_b, double margin, Manifold& manifold) {
  manifold.count = 0;
  const Vec3 normal = at_b.R[2];
  thread_local std::vector<ManifoldPoint> points;
  points.clear();
  const Lowest plane = {at_a, normal, transposed_times(at_a.R, normal), dot(normal, at_a.x - at_b.x), margin, points};
  std::visit([&](const auto& shape) { add_lowest(plane, shape); }, a);
  if (!points.empty()) keep_points(points, reach_of(a), 0.0, manifold);
}

}  // namespace pantin
