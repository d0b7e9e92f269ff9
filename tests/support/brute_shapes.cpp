#include "support/brute_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pantin::brute {

namespace {

constexpr Real most = std::numeric_limits<Real>::infinity();

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator*(const Point& a, Real s) { return {a[0] * s, a[1] * s, a[2] * s}; }
Real dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real norm(const Point& a) { return std::sqrt(dot(a, a)); }
Real real(double x) { return static_cast<Real>(x); }
Point point(Vec3 v) { return {real(v[0]), real(v[1]), real(v[2])}; }

/// Whether no point is beyond the plane of three.
bool bounds(const std::vector<Point>& points, std::size_t i, std::size_t j, std::size_t k) {
  const Point n = cross(points[j] - points[i], points[k] - points[i]);
  const Real length = norm(n), reach = norm(points[j] - points[i]) + norm(points[k] - points[i]);
  if (!(length > 1e-12L * reach * reach)) return false;
  bool above = false, below = false;
  for (const Point& p : points) {
    const Real height = dot(n, p - points[i]) / length;
    above = above || height > 1e-13L * reach;
    below = below || height < -1e-13L * reach;
  }
  return !above || !below;
}

Real gap(const Convex& a, const Convex& b, const Point& n) {
  Real low = most, high = -most;
  for (const Point& p : a.points) low = std::min(low, dot(n, p));
  for (const Point& p : b.points) high = std::max(high, dot(n, p));
  return low - high;
}

void offer_gap(const Convex& a, const Convex& b, const Point& n, Real& widest) {
  const Real length = norm(n);
  if (!(length > 0.0L)) return;
  widest = std::max({widest, gap(a, b, n * (1.0L / length)), gap(a, b, n * (-1.0L / length))});
}

/// The widest of the directions that may be the best where two overlap.
Real widest_gap(const Convex& a, const Convex& b) {
  Real widest = -most;
  for (const Convex* c : {&a, &b})
    for (const auto& t : c->triangles)
      offer_gap(a, b, cross(c->points[t[1]] - c->points[t[0]], c->points[t[2]] - c->points[t[0]]), widest);
  for (const auto& i : a.edges)
    for (const auto& j : b.edges) {
      const Point u = a.points[i[1]] - a.points[i[0]], v = b.points[j[1]] - b.points[j[0]], n = cross(u, v);
      if (norm(n) > 1e-9L * norm(u) * norm(v)) offer_gap(a, b, n, widest);
    }
  return widest;
}

Real to_segment(const Point& p, const Point& q, const Point& r) {
  const Point e = r - q;
  const Real t = std::clamp(dot(p - q, e) / dot(e, e), 0.0L, 1.0L);
  return norm(p - (q + e * t));
}

Real of_segments(const Point& p, const Point& q, const Point& r, const Point& s) {
  Real least = std::min({to_segment(p, r, s), to_segment(q, r, s), to_segment(r, p, q), to_segment(s, p, q)});
  const Point u = q - p, v = s - r, w = r - p, n = cross(u, v);
  const Real square = dot(n, n);
  if (!(square > 1e-30L * dot(u, u) * dot(v, v))) return least;
  const Real on_u = dot(cross(w, v), n) / square, on_v = dot(cross(w, u), n) / square;
  if (on_u >= 0.0L && on_u <= 1.0L && on_v >= 0.0L && on_v <= 1.0L) least = std::fabs(dot(w, n)) / std::sqrt(square);
  return least;
}

/// Infinite where a point is not above the inside of a triangle.
Real to_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point n = cross(b - a, c - a);
  if (dot(cross(b - a, p - a), n) < 0.0L || dot(cross(c - b, p - b), n) < 0.0L || dot(cross(a - c, p - c), n) < 0.0L)
    return most;
  return std::fabs(dot(p - a, n)) / norm(n);
}

Real least_distance(const Convex& a, const Convex& b) {
  Real least = most;
  for (const Point& p : a.points)
    for (const Point& q : b.points) least = std::min(least, norm(p - q));
  const auto to_features = [&](const Convex& from, const Convex& to) {
    for (const Point& p : from.points) {
      for (const auto& e : to.edges) least = std::min(least, to_segment(p, to.points[e[0]], to.points[e[1]]));
      for (const auto& t : to.triangles)
        least = std::min(least, to_triangle(p, to.points[t[0]], to.points[t[1]], to.points[t[2]]));
    }
  };
  to_features(a, b);
  to_features(b, a);
  for (const auto& i : a.edges)
    for (const auto& j : b.edges)
      least = std::min(least, of_segments(a.points[i[0]], a.points[i[1]], b.points[j[0]], b.points[j[1]]));
  return least;
}

}  // namespace

Convex convex(std::span<const Vec3> points, double radius) {
  Convex result;
  result.radius = real(radius);
  for (const Vec3 p : points) result.points.push_back(point(p));
  std::set<std::array<std::size_t, 2>> edges;
  const std::size_t count = points.size();
  if (count == 2) edges.insert({0, 1});
  for (std::size_t i = 0; i < count; i++)
    for (std::size_t j = i + 1; j < count; j++)
      for (std::size_t k = j + 1; k < count; k++) {
        if (!bounds(result.points, i, j, k)) continue;
        result.triangles.push_back({i, j, k});
        edges.insert({{i, j}, {j, k}, {i, k}});
      }
  result.edges.assign(edges.begin(), edges.end());
  return result;
}

Convex convex(const BoxShape& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(box.half * vec(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return convex(corners);
}

Convex put(const Convex& own, const Pose& pose, Vec3 origin) {
  Convex result = own;
  const Point x = point(pose.x) - point(origin);
  for (Point& p : result.points) p = x + point(pose.R[0]) * p[0] + point(pose.R[1]) * p[1] + point(pose.R[2]) * p[2];
  return result;
}

double distance(const Convex& a, const Convex& b) {
  const Real radius = a.radius + b.radius, widest = widest_gap(a, b);
  const bool overlap = widest <= 0.0L && (!a.triangles.empty() || !b.triangles.empty());
  return static_cast<double>((overlap ? widest : least_distance(a, b)) - radius);
}

double gap_along(const Convex& a, const Convex& b, Vec3 normal) {
  return static_cast<double>(gap(a, b, point(normal)) - a.radius - b.radius);
}

Mat3 random_turn(Random& random) {
  Quat q;
  double square = 2.0;
  while (square > 1.0 || square < 0.01) {
    q = {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0,
         2.0 * random.uniform() - 1.0};
    square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  }
  return matrix(normalised(q));
}

Vec3 random_vector(Random& random, double half) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return vec(2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0) * half;
}

Vec3 random_direction(Random& random) { return random_turn(random)[0]; }

std::vector<Vec3> random_points(Random& random, std::size_t count, double radius) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; i++) points.push_back(random_direction(random) * radius);
  return points;
}

}  // namespace pantin::brute
