#include "contacts/manifold.hpp"

#include <optional>

#include "base/functions.hpp"
#include "contacts/manifold_parts.hpp"

namespace pantin {

namespace {

/// Part of the thickness by which shapes may overlap where one passes over the other: more than is left of what was pushed out.
constexpr double passing_overlap = 5e-4;
/// Part of the thickness below which nothing nears.
constexpr double no_approach = 1e-9;
/// [rad] past which a turn is not foreseen.
constexpr double most_turn = 0.5;
constexpr int most_rounds = 30;

struct Pair {
  const Geometry& a;
  const Pose& at_a;
  const Geometry& b;
  const Pose& at_b;
  double margin, overlap;  ///< [m]
};

Pose moved(const Pose& pose, const Travel& motion, double part) {
  const double angle = norm(motion.turn) * part;
  if (!(angle > 0.0)) return {pose.x + motion.way * part, pose.R};
  const Vec3 u = motion.turn * (part * functions::sin(0.5 * angle) / angle);
  return {pose.x + motion.way * part, matrix(Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]}) * pose.R};
}

Vec3 way_of(const Travel& motion, const Pose& at_a, Vec3 on_a) {
  return motion.way + cross(motion.turn, on_a - at_a.x);
}

/// The part of the motion after which the shapes overlap by so much as none that pass do, by Newton's method: of straight
/// motion the distance is convex, and no step goes too far.
std::optional<double> first_overlap(const Pair& pair, const Travel& motion, double most) {
  SeparationCache cache;
  double part = 0.0;
  for (int round = 0; round < most_rounds; round++) {
    const Pose pose = moved(pair.at_a, motion, part);
    const Separation gap = separation(pair.a, pose, pair.b, pair.at_b, infinity, &cache);
    const double left = gap.distance + pair.overlap;
    if (left <= 1e-3 * pair.overlap) return part;
    const double nearing = -dot(gap.normal, way_of(motion, pose, gap.on_a));
    if (!(nearing * most > left - part * nearing)) {
      if (norm2(motion.turn) == 0.0) return {};
      const Pose end = moved(pair.at_a, motion, 1.0);
      const bool meets = separation(pair.a, end, pair.b, pair.at_b, 0.0, &cache).distance <= -pair.overlap;
      return meets ? std::optional(1.0) : std::nullopt;
    }
    part += left / nearing;
  }
  return part;
}

void set_points(const Pair& pair, const Pose& at_a, SeparationCache& cache, Manifold& manifold) {
  const auto *box_a = std::get_if<BoxShape>(&pair.a), *box_b = std::get_if<BoxShape>(&pair.b);
  if (box_a != nullptr && box_b != nullptr)
    box_on_box(*box_a, at_a, *box_b, pair.at_b, pair.margin, cache, manifold);
  else
    convex_on_convex(pair.a, at_a, pair.b, pair.at_b, pair.margin, cache, manifold);
}

/// How many times the motion takes a past the plane of a point; 0 where it ends before that of each.
double passes(const Pair& pair, const Travel& motion, const Manifold& manifold) {
  double most = 0.0;
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    const ManifoldPoint& p = manifold.points[i];
    const double nearing = -dot(p.normal, way_of(motion, pair.at_a, p.on_a));
    if (nearing * passing_overlap <= no_approach * pair.overlap || nearing <= p.gap) continue;
    most = std::fmax(most, std::fmax(1.0, (p.gap + 2.0 * pair.overlap) / nearing));
  }
  return most;
}

/// Points that the motion would pass are put to the test: what only passes by needs none, and what meets b has those of
/// where it does, unless it touches already.
void foresee(const Pair& pair, const Travel& motion, Manifold& manifold) {
  const double most = passes(pair, motion, manifold);
  if (most == 0.0 || most * norm(motion.turn) > most_turn) return;
  const std::optional<double> part = first_overlap(pair, motion, most);
  if (!part) {
    manifold.count = 0;
    return;
  }
  double least = infinity;
  for (std::uint32_t i = 0; i < manifold.count; i++) least = std::fmin(least, manifold.points[i].gap);
  if (least <= pair.overlap) return;
  SeparationCache cache;
  Manifold there;
  const Pose pose = moved(pair.at_a, motion, *part);
  set_points(pair, pose, cache, there);
  if (there.count == 0) return;
  manifold = there;
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    ManifoldPoint& p = manifold.points[i];
    const Vec3 now = pair.at_a.to_world(pose.to_local(p.on_a));
    p.gap += dot(p.normal, now - p.on_a);
    p.on_a = now;
  }
}

}  // namespace

void find_manifolds(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, double margin,
                    SeparationCache& cache, ManifoldSink& sink, const Travel& motion) {
  Manifold manifold;
  if (is_convex(b)) {
    const Pair pair{a, at_a, b, at_b, margin, passing_overlap * std::fmin(thickness_of(a), thickness_of(b))};
    set_points(pair, at_a, cache, manifold);
    foresee(pair, motion, manifold);
  } else if (std::holds_alternative<HalfSpaceShape>(b)) {
    convex_on_plane(a, at_a, at_b, margin, manifold);
  } else {
    return convex_on_triangles(a, at_a, b, at_b, margin, sink);
  }
  if (manifold.count > 0) sink.take(manifold, 0);
}

}  // namespace pantin
