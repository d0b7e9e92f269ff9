// The judge of shapes: random pairs of each two kinds, whether they overlap and how deep as the engine and as libccd say, and
// how long each takes; beside them a whole contact of a pair, with all its points.
#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <ccd/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/clock.hpp"
#include "contacts/manifold.hpp"
#include "shapes/distance.hpp"
#include "shapes/hull.hpp"
#include "support/brute_shapes.hpp"

namespace {

using namespace pantin;

constexpr int pairs = 4000;
constexpr double unsure = 1e-5;  // [m] of overlap or gap, at which libccd may say either
constexpr std::array<const char*, 5> kinds = {"ball", "capsule", "box", "cylinder", "hull"};

/// Written anew from its definition, without the engine's supports.
struct Convex {
  int kind = 0;
  Geometry geometry = BallShape{0.5};
  double radius = 0.0;
  Vec3 half = zero3();
  std::vector<Vec3> points = {};
  Pose pose = {};

  Vec3 support(Vec3 d) const {
    switch (kind) {
      case 0: return d * (radius / norm(d));
      case 1: return d * (radius / norm(d)) + vec(0, 0, std::copysign(half[2], d[2]));
      case 2: return vec(std::copysign(half[0], d[0]), std::copysign(half[1], d[1]), std::copysign(half[2], d[2]));
      case 3: {
        const double across = std::hypot(d[0], d[1]), z = std::copysign(half[2], d[2]);
        return across > 0.0 ? vec(radius * d[0] / across, radius * d[1] / across, z) : vec(0, 0, z);
      }
      default:
        return *std::max_element(points.begin(), points.end(), [&](Vec3 a, Vec3 b) { return dot(a, d) < dot(b, d); });
    }
  }
};

Convex random_convex(Random& random, int kind) {
  const auto length = [&] { return 0.2 + 0.3 * random.uniform(); };
  Convex c;
  c.kind = kind;
  c.radius = length();
  c.half = vec(length(), length(), length());
  if (kind == 4) c.points = brute::random_points(random, 12, 0.5);
  switch (kind) {
    case 0: c.geometry = BallShape{c.radius}; break;
    case 1: c.geometry = CapsuleShape{c.radius, c.half[2]}; break;
    case 2: c.geometry = BoxShape{c.half}; break;
    case 3: c.geometry = CylinderShape{c.radius, c.half[2]}; break;
    default: c.geometry = make_hull(c.points);
  }
  c.pose = {brute::random_vector(random, 0.35), brute::random_turn(random)};
  return c;
}

/// How far [m] a must go along d to be beside b.
double way_out(const Convex& a, const Convex& b, Vec3 d) {
  const auto farthest = [](const Convex& c, Vec3 along) {
    return dot(c.pose.to_world(c.support(transposed_times(c.pose.R, along))), along);
  };
  return (farthest(b, d) + farthest(a, -d)) / norm(d);
}

void support_for_ccd(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto& c = *static_cast<const Convex*>(object);
  const Vec3 d = vec(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 x = c.pose.to_world(c.support(transposed_times(c.pose.R, d)));
  ccdVec3Set(point, x[0], x[1], x[2]);
}
void centre_for_ccd(const void* object, ccd_vec3_t* centre) {
  const Vec3 x = static_cast<const Convex*>(object)->pose.x;
  ccdVec3Set(centre, x[0], x[1], x[2]);
}

ccd_t settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support_for_ccd;
  ccd.center1 = ccd.center2 = centre_for_ccd;
  ccd.max_iterations = 500;
  ccd.epa_tolerance = ccd.mpr_tolerance = 1e-8;
  return ccd;
}

struct Points final : ManifoldSink {
  std::uint32_t count = 0;
  void take(const Manifold& manifold, std::uint32_t) override { count += manifold.count; }
};

template <class One>
double nanoseconds_each(const std::vector<std::array<Convex, 2>>& all, One one) {
  const double start = now();
  for (const auto& [a, b] : all) one(a, b);
  return 1e9 * (now() - start) / static_cast<double>(all.size());
}

void judge(int one, int other) {
  Random random{.seed = 7};
  const ccd_t ccd = settings();
  std::vector<std::array<Convex, 2>> all;
  for (int i = 0; i < pairs; i++) all.push_back({random_convex(random, one), random_convex(random, other)});
  int against = 0, overlaps = 0, unfound = 0;
  double longer = 0.0, shorter = 0.0, wrong = 0.0;
  for (const auto& [a, b] : all) {
    const Separation found = separation(a.geometry, a.pose, b.geometry, b.pose);
    const bool overlap = ccdGJKIntersect(&a, &b, &ccd) != 0;
    if (std::fabs(found.distance) > unsure && overlap != (found.distance < 0.0)) against++;
    if (!overlap) continue;
    overlaps++;
    ccd_real_t depth = 0.0;
    ccd_vec3_t direction, position;
    if (ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position) != 0) {
      unfound++;
      continue;
    }
    const Vec3 d = vec(direction.v[0], direction.v[1], direction.v[2]);
    const double least = std::fmin(way_out(a, b, d), way_out(a, b, -d));
    longer = std::fmax(longer, -found.distance - least);
    shorter = std::fmax(shorter, least + found.distance);
    wrong = std::fmax(wrong, std::fabs(way_out(a, b, found.normal) + found.distance));
  }
  double sum = 0.0;  // kept from being left out
  const double own = nanoseconds_each(all, [&](const Convex& a, const Convex& b) {
    sum += separation(a.geometry, a.pose, b.geometry, b.pose).distance;
  });
  const double contact = nanoseconds_each(all, [&](const Convex& a, const Convex& b) {
    SeparationCache cache;
    Points points;
    find_manifolds(a.geometry, a.pose, b.geometry, b.pose, Ahead(0.02), cache, points);
    sum += points.count;
  });
  const double theirs = nanoseconds_each(all, [&](const Convex& a, const Convex& b) {
    ccd_real_t depth = 0.0;
    ccd_vec3_t direction, position;
    sum += ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position);
  });
  std::printf("| %s, %s | %d | %d | %d | %.0e | %.0e | %.0e | %.0f | %.0f | %.0f |\n",
              kinds[static_cast<std::size_t>(one)], kinds[static_cast<std::size_t>(other)], overlaps, against, unfound,
              longer, shorter, wrong, own, contact, std::isfinite(sum) ? theirs : 0.0);
}

}  // namespace

int main() {
  std::printf(
      "%d random pairs of each two kinds, of 0.4 to 1 m; depths [m] beside those of libccd's expanding polytope\n"
      "\n| pair | overlap | verdicts against | not found by libccd | deeper by | less deep by | ns a distance | ns a "
      "contact | "
      "ns libccd |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      pairs);
  for (int one = 0; one < 5; one++)
    for (int other = one; other < 5; other++) judge(one, other);
  return 0;
}
