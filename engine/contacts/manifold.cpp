#include "contacts/manifold.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "base/functions.hpp"
#include "contacts/manifold_pair.hpp"
#include "shapes/core.hpp"
#include "shapes/hull.hpp"

namespace pantin {

namespace {

/// Part of the thickness below which nothing nears.
constexpr double no_approach = 1e-6;
constexpr int most_rounds = 30;

Vec3 way_of(const Travel& motion, const Pose& at_a, Vec3 on_a) {
  return motion.displacement + cross(motion.turn, on_a - at_a.x);
}

struct Meeting {
  double part;
  Vec3 normal;
};

/// When a motion first makes a overlap by so much [m] what `gap_at` (pose of a) tells the distance to, by Newton's method: of
/// straight motion the distance is convex, and no step goes too far.
template <class GapAt>
std::optional<Meeting> first_overlap(const Pair& pair, const Travel& motion, double overlap, GapAt&& gap_at) {
  double part = 0.0;
  for (int round = 0; round < most_rounds; round++) {
    const Pose pose = moved(pair.at_a, motion, part);
    const Separation gap = gap_at(pose);
    const double left = gap.distance + overlap;
    if (left <= 1e-3 * pair.overlap()) return Meeting{part, gap.normal};
    const double nearing = -dot(gap.normal, way_of(motion, pose, gap.on_a));
    if (nearing * (1.0 - part) >= left) {
      part += left / nearing;
      continue;
    }
    if (norm2(motion.turn) == 0.0 || part == 1.0) return {};
    part = 1.0;
  }
  return Meeting{part, zero3()};
}

std::optional<Meeting> first_overlap(const Pair& pair, const Travel& motion, double overlap) {
  SeparationCache cache;
  return first_overlap(pair, motion, overlap,
                       [&](const Pose& pose) { return separation(pair.a, pose, pair.b, pair.at_b, infinity, &cache); });
}

/// The same of the plane of a point.
std::optional<Meeting> first_overlap_of_plane(const Pair& pair, const Travel& motion, const ManifoldPoint& p) {
  const Core core = core_of(pair.a);
  return first_overlap(pair, motion, 0.0, [&](const Pose& pose) {
    Separation gap;
    gap.normal = p.normal;
    gap.on_a = pose.to_world(support(core, transposed_times(pose.R, -p.normal))) - p.normal * core.rounding;
    gap.distance = dot(p.normal, gap.on_a - p.on_a) + p.gap;
    return gap;
  });
}

/// When a motion first makes shapes touch that come to overlap as none do that pass.
std::optional<Meeting> first_meeting(const Pair& pair, const Travel& motion) {
  const std::optional<Meeting> meets = first_overlap(pair, motion, pair.overlap());
  if (!meets || meets->part == 0.0 || norm2(meets->normal) == 0.0) return meets;
  const std::optional<Meeting> touches = first_overlap(pair, motion, 0.0);
  return touches && norm2(touches->normal) > 0.0 ? touches : meets;
}

/// How far a motion takes a past the plane of a point [m].
double way_past(const Pair& pair, const Travel& motion, const ManifoldPoint& p) {
  const double nearing = -dot(p.normal, way_of(motion, pair.at_a, p.on_a));
  return nearing > no_approach * pair.thickness ? nearing - p.gap : 0.0;
}

/// What is to be foreseen: two that rebound and strike, though one kept the other out in the last drift, did not meet in it.
Travel motion_of(const Pair& pair, const ManifoldSink& sink, std::span<const ManifoldPoint> points) {
  if (!pair.ahead.strikes) return sink.motion();
  const Travel motion = sink.motion_even_if_held();
  const auto strikes = [&](const ManifoldPoint& p) {
    return p.gap > held_gap * pair.thickness && -dot(p.normal, way_of(motion, pair.at_a, p.on_a)) > pair.blow();
  };
  return std::any_of(points.begin(), points.end(), strikes) ? motion : sink.motion();
}

void set_points_there(const Pair& pair, const Travel& motion, double part, Manifold& manifold) {
  SeparationCache cache;
  Manifold there;
  const Pose pose = moved(pair.at_a, motion, part);
  set_points(pair, pose, cache, there);
  if (there.count == 0) return;
  manifold = there;
  const ManifoldPoint& first = there.points[0];
  if (-dot(first.normal, way_of(motion, pose, first.on_a)) > pair.blow()) manifold.meeting = {pose, part};
  move_back(pair, pose, manifold);
}

bool is_round(const Geometry& shape) {
  return std::holds_alternative<BallShape>(shape) || std::holds_alternative<CapsuleShape>(shape) ||
         std::holds_alternative<CylinderShape>(shape);
}

/// Whether a motion that goes so far past the planes of points [m] ends beside b all the same.
bool ends_beside(const Pair& pair, const Travel& motion, double past) {
  SeparationCache cache;
  const double left = separation(pair.a, moved(pair.at_a, motion, 1.0), pair.b, pair.at_b, infinity, &cache).distance;
  return left >= -closed_gap * pair.thickness && left + past > no_approach * pair.thickness;
}

/// A motion that would go past the plane of a point is tried: where it meets b it has the points of there, and none where it
/// only passes by. One that goes hardly past is tried as if something pressed; of what is round it has the points of where it
/// ends, if that is beside b.
void foresee(const Pair& pair, Travel motion, Manifold& manifold) {
  const double farthest = norm(motion.displacement) + norm(motion.turn) * reach_of(pair.a);
  if (!(farthest > no_approach * pair.thickness)) return;
  double most = 0.0, least = infinity;
  Vec3 normal = zero3();
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    const double past = way_past(pair, motion, manifold.points[i]);
    least = std::fmin(least, manifold.points[i].gap);
    if (past <= most) continue;
    most = past;
    normal = manifold.points[i].normal;
  }
  if (most == 0.0) return;
  motion.turn = turn_of(pair.a, pair.at_a, motion.turn);
  if (norm(motion.turn) > most_turn) return;
  const double deep = 2.0 * pair.overlap();
  const Travel free = motion;
  if (most < deep) {
    if ((is_round(pair.a) || is_round(pair.b)) && ends_beside(pair, motion, most))
      return set_points_there(pair, motion, 1.0, manifold);
    motion.displacement -= normal * (deep - most);
  }
  const std::optional<Meeting> meeting = first_meeting(pair, motion);
  if (!meeting) {
    manifold.count = 0;
    return;
  }
  if (!(least > pair.held_already() || dot(meeting->normal, normal) < 1.0 - same_normal)) return;
  if (most < deep && pair.ahead.strikes)
    if (const auto touches = first_overlap(pair, free, 0.0); touches && norm2(touches->normal) > 0.0)
      return set_points_there(pair, free, touches->part, manifold);
  set_points_there(pair, motion, meeting->part, manifold);
}

/// What may go farther than its inner ball is large may turn past what a point holds: the ball is held, too, where it would meet
/// b itself.
void add_inner_ball(const Pair& pair, const ManifoldSink& sink, Manifold& manifold) {
  const auto [centre, radius] = inner_ball(pair.a);
  if (manifold.count == 0 || pair.ahead.margin < radius || std::holds_alternative<BallShape>(pair.a)) return;
  if (!(radius > 0.0)) return;
  const Geometry ball = BallShape{radius};
  Manifold of_ball;
  SeparationCache cache;
  const Pose at = {pair.at_a.to_world(centre), pair.at_a.R};
  const Pair inner{ball, at, pair.b, pair.at_b, pair.ahead, std::fmin(2.0 * radius, thickness_of(pair.b))};
  set_points(inner, inner.at_a, cache, of_ball);
  if (of_ball.count > 0) foresee(inner, {sink.motion_even_if_held().displacement, zero3()}, of_ball);
  if (of_ball.count == 0) return;
  manifold.points[manifold.count] = of_ball.points[0];
  manifold.points[manifold.count++].id = inner_ball_id;
}

/// Where faces of what is no convex shape are met.
std::optional<PoseAhead> meeting_with_faces(const Pair& pair, Travel motion, std::span<const PartManifold> found) {
  motion.turn = turn_of(pair.a, pair.at_a, motion.turn);
  if (norm(motion.turn) > most_turn) return {};
  double first = infinity;
  for (const auto& [manifold, part] : found)
    for (std::uint32_t i = 0; i < manifold.count; i++) {
      const ManifoldPoint& p = manifold.points[i];
      if (p.gap <= pair.held_already() || way_past(pair, motion, p) <= 0.0) continue;
      const std::optional<Meeting> meeting = first_overlap_of_plane(pair, motion, p);
      if (meeting && norm2(meeting->normal) > 0.0) first = std::fmin(first, meeting->part);
    }
  if (first == infinity) return {};
  return PoseAhead{moved(pair.at_a, motion, first), first};
}

/// Tells the points of planes and triangles that a motion meets, or else those of now.
void tell_foreseen(const Pair& pair, ManifoldSink& sink) {
  thread_local Collected now, there;
  now.clear();
  now.to = there.to = &sink;
  find_on_faces(pair, pair.at_a, now);
  if (now.behind) sink.tell_behind();
  const Travel motion = now.found.empty() ? Travel{} : sink.motion();
  const std::optional<PoseAhead> meeting = meeting_with_faces(pair, motion, now.found);
  Collected* told = &now;
  if (meeting) {
    const Pose& pose = meeting->pose;
    there.clear();
    find_on_faces(pair, pose, there);
    const bool strikes = std::any_of(there.found.begin(), there.found.end(), [&](const PartManifold& f) {
      const ManifoldPoint& p = f.manifold.points[0];
      return std::fabs(p.gap) < pair.overlap() && -dot(p.normal, way_of(motion, pose, p.on_a)) > pair.blow();
    });
    if (strikes) {
      told = &there;
      for (PartManifold& f : there.found) {
        f.manifold.meeting = meeting;
        move_back(pair, pose, f.manifold);
      }
    }
  }
  if (!told->found.empty() && add_turned(pair, sink, told->found))
    for (PartManifold& f : told->found) f.manifold.meeting.reset();
  for (const auto& [manifold, part] : told->found) sink.take(manifold, part);
}

}  // namespace

Pose moved(const Pose& pose, const Travel& motion, double part) {
  const double angle = norm(motion.turn) * part;
  if (!(angle > 0.0)) return {pose.x + motion.displacement * part, pose.R};
  const Vec3 u = motion.turn * (part * functions::sin(0.5 * angle) / angle);
  return {pose.x + motion.displacement * part, matrix(Quat{functions::cos(0.5 * angle), u[0], u[1], u[2]}) * pose.R};
}

void find_on_faces(const Pair& pair, const Pose& at_a, ManifoldSink& sink) {
  if (!std::holds_alternative<HalfSpaceShape>(pair.b))
    return convex_on_triangles(pair.a, at_a, pair.b, pair.at_b, pair.ahead.margin, sink);
  Manifold manifold;
  convex_on_plane(pair.a, at_a, pair.at_b, pair.ahead.margin, manifold);
  if (manifold.count > 0) sink.take(manifold, 0);
}

void set_points(const Pair& pair, const Pose& at_a, SeparationCache& cache, Manifold& manifold) {
  const auto *box_a = std::get_if<BoxShape>(&pair.a), *box_b = std::get_if<BoxShape>(&pair.b);
  if (box_a != nullptr && box_b != nullptr)
    box_on_box(*box_a, at_a, *box_b, pair.at_b, pair.ahead, cache, manifold);
  else
    convex_on_convex(pair.a, at_a, pair.b, pair.at_b, pair.ahead, cache, manifold);
}

void move_back(const Pair& pair, const Pose& pose, Manifold& manifold) {
  for (std::uint32_t i = 0; i < manifold.count; i++) {
    ManifoldPoint& p = manifold.points[i];
    const Vec3 now = pair.at_a.to_world(pose.to_local(p.on_a));
    p.gap += dot(p.normal, now - p.on_a);
    p.on_a = now;
  }
}

InnerBall inner_ball(const Geometry& shape) {
  const auto* hull = std::get_if<std::shared_ptr<const Hull>>(&shape);
  if (hull == nullptr) return {zero3(), 0.5 * thickness_of(shape)};
  return {(*hull)->inner_centre, (*hull)->inner_radius};
}

void find_manifolds(const Geometry& a, const Pose& at_a, const Geometry& b, const Pose& at_b, Ahead ahead,
                    SeparationCache& cache, ManifoldSink& sink) {
  const Pair pair{a, at_a, b, at_b, ahead, std::fmin(thickness_of(a), thickness_of(b))};
  if (!is_convex(b)) return tell_foreseen(pair, sink);
  Manifold manifold;
  set_points(pair, at_a, cache, manifold);
  if (manifold.count == 0) return;
  foresee(pair, motion_of(pair, sink, points_of(manifold)), manifold);
  add_turned(pair, sink, manifold);
  add_inner_ball(pair, sink, manifold);
  if (manifold.count > 0) sink.take(manifold, 0);
}

}  // namespace pantin
