#include "view/shadow_region.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

namespace {

constexpr double farthest = 24.0;    // where shadows end
constexpr double least_ratio = 0.1;  // of the depth of what is near to that of what is far
constexpr double margin = 0.04;

/// A convex one; it asks for no memory.
struct Polygon {
  std::array<Vec3, 10> corners;  // a rectangle's, and one for each of six planes
  std::size_t count = 0;
  void add(Vec3 corner) { corners[count++] = corner; }
};

/// What of it is on the side of a plane to which the normal points.
Polygon clipped(const Polygon& polygon, Vec3 normal, double offset) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; i++) {
    const Vec3 a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.count];
    const double from = dot(normal, a) - offset, to = dot(normal, b) - offset;
    if (from >= 0.0) kept.add(a);
    if ((from < 0.0) != (to < 0.0)) kept.add(a + (b - a) * (from / (from - to)));
  }
  return kept;
}

/// Calls a function for each corner of what is seen of a box.
template <class Function>
void for_each_seen_corner(Vec3 lower, Vec3 upper, const Camera& camera, double aspect, const Function& function) {
  const double tall = std::tan(0.5 * camera.fov), wide = tall * aspect, near = camera.nearest() / camera.distance;
  const Vec3 f = camera.forward(), r = camera.right(), u = camera.up();
  for (int axis = 0; axis < 3; axis++)
    for (const Vec3 end : {lower, upper}) {
      Polygon face;
      const int b = (axis + 1) % 3, c = (axis + 2) % 3;
      for (int i = 0; i < 4; i++) {
        Vec3 corner = end;
        corner[b] = i == 1 || i == 2 ? upper[b] : lower[b];
        corner[c] = i >= 2 ? upper[c] : lower[c];
        face.add(corner);
      }
      for (const Vec3 side : {f * wide + r, f * wide - r, f * tall + u, f * tall - u}) face = clipped(face, side, 0.0);
      face = clipped(clipped(face, f, near), -f, -farthest);
      for (std::size_t i = 0; i < face.count; i++) function(face.corners[i]);
    }
  // Of the picture's edges, where they begin and end within the box.
  for (const double depth : {near, farthest})
    for (int i = 0; i < 4; i++) {
      const Vec3 p = (f + r * (i & 1 ? wide : -wide) + u * (i & 2 ? tall : -tall)) * depth;
      bool within = true;
      for (int k = 0; k < 3; k++) within = within && p[k] >= lower[k] && p[k] <= upper[k];
      if (within) function(p);
    }
}

struct Range {
  double least = 1e300, most = -1e300;
  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

/// What of the box is above the ground, with the shadow that it throws there.
void widen_by_shadow(Vec3& lower, Vec3& upper, double level, const std::array<double, 2>& slant) {
  const double low = std::max(lower[1] - level, 0.0), high = std::max(upper[1] - level, 0.0);
  for (const std::size_t i : {0u, 1u}) {
    const int axis = i == 0 ? 0 : 2;
    lower[axis] -= std::max({low * slant[i], high * slant[i], 0.0});
    upper[axis] -= std::min({low * slant[i], high * slant[i], 0.0});
  }
  lower[1] = level;
  upper[1] = std::max(upper[1], level);
}

}  // namespace

ShadowRegion find_shadow_region(Vec3 lower, Vec3 upper, double level, const std::array<double, 2>& slant,
                                const Camera& camera, double aspect) {
  widen_by_shadow(lower, upper, level, slant);
  ShadowRegion region;
  const Vec3 forward = camera.forward(), up = camera.up();
  const Vec3 ahead = std::fabs(forward[1]) < 0.9 ? forward : up * (forward[1] < 0.0 ? 1.0 : -1.0);
  const double size = std::hypot(ahead[0], ahead[2]), x = ahead[0] / size, z = ahead[2] / size;
  std::array<std::array<double, 2>, 68> fallen;  // along and across
  std::size_t count = 0;
  Range along, depth;
  for_each_seen_corner(lower, upper, camera, aspect, [&](Vec3 p) {
    const double px = p[0] - slant[0] * (p[1] - level), pz = p[2] - slant[1] * (p[1] - level);
    fallen[count] = {px * x + pz * z, px * -z + pz * x};
    along.add(fallen[count++][0]);
    depth.add(dot(p, forward));
  });
  if (count == 0) return region;
  region.empty = false;
  const double ratio = std::clamp(std::sqrt(depth.least / depth.most), least_ratio, 0.95);
  const double length = std::max((along.most - along.least) * (1.0 + 2.0 * margin), 1e-9 * depth.most);
  const double start = 0.5 * (along.least + along.most - length);
  const double first = length * ratio / (1.0 - ratio), last = first + length;  // depths of the map
  Range across;
  for (std::size_t i = 0; i < count; i++) across.add(fallen[i][1] / (fallen[i][0] - start + first));
  const double middle = 0.5 * (across.least + across.most);
  const double half = std::max(0.5 * (across.most - across.least) * (1.0 + 2.0 * margin), 1e-9 * depth.most / last);
  const double b = 2.0 * first * last / length, a = (last + first) / length;
  const Eigen::Vector3d row(x, z, first - start);
  Eigen::Matrix3d m;
  m.row(0) = (Eigen::Vector3d(-z, x, 0.0) - middle * row) / half;
  m.row(1) = a * row - Eigen::Vector3d(0.0, 0.0, b);
  m.row(2) = row;
  region.to_map = m.cast<float>();
  for (int i = 0; i < 4; i++) {
    const double w = i & 2 ? last : first, s = w - first + start, t = w * (middle + (i & 1 ? half : -half));
    region.corners[static_cast<std::size_t>(i)] = {static_cast<float>(s * x - t * z),
                                                   static_cast<float>(s * z + t * x)};
  }
  region.along = static_cast<float>(1.0 / b);
  region.across = static_cast<float>(half);
  return region;
}

}  // namespace pantin
