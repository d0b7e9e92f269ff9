// Where hulls roll on within the step.
#include <algorithm>
#include <array>

#include "contacts/manifold_pair.hpp"
#include "shapes/core.hpp"
#include "shapes/hull.hpp"

namespace pantin {

namespace {

/// Whether a turn [rad] of a hull brings a corner of it farther out along a direction than all points of it by so much [m].
bool turns_past(const Geometry& shape, const Pose& at, Vec3 turn, Vec3 out, std::span<const Vec3> points, double by) {
  const auto* hull = std::get_if<std::shared_ptr<const Hull>>(&shape);
  if (hull == nullptr || !(norm(turn) * (*hull)->reach > by)) return false;
  const Vec3 local = transposed_times(moved(at, {zero3(), turn}, 1.0).R, out);
  const double farthest_out = dot(local, (*hull)->vertices[farthest(**hull, local)]);
  return std::all_of(points.begin(), points.end(),
                     [&](Vec3 p) { return farthest_out - dot(local, at.to_local(p)) > by; });
}

enum class Turns : std::uint8_t { none, a, b };

/// Which of the two turns to such a corner against the other.
Turns turns_past(const Pair& pair, const Travel& motion, const Manifold& manifold) {
  if (manifold.count == 0 || norm2(motion.turn) == 0.0 || norm(motion.turn) > most_turn) return Turns::none;
  const double by = closed_gap * pair.thickness;
  const Vec3 normal = manifold.points[0].normal;
  std::array<Vec3, std::tuple_size_v<decltype(manifold.points)>> on;
  const std::span<const Vec3> points(on.data(), manifold.count);
  const auto set = [&](double part) {
    for (std::uint32_t i = 0; i < manifold.count; i++)
      on[i] = manifold.points[i].on_a - manifold.points[i].normal * (manifold.points[i].gap * part);
  };
  set(0.0);
  if (turns_past(pair.a, pair.at_a, motion.turn, -normal, points, by)) return Turns::a;
  set(1.0);
  return turns_past(pair.b, pair.at_b, -motion.turn, normal, points, by) ? Turns::b : Turns::none;
}

/// Puts first the lowest point of a manifold by some height [m], and second one that is far from it and hardly higher.
template <class Height>
void put_lowest_first(const Pair& pair, Manifold& manifold, const Height& height) {
  const double low = half_as_low * std::fmin(reach_of(pair.a), reach_of(pair.b));
  const auto begin = manifold.points.begin(), end = begin + manifold.count;
  const auto put_first = [&](auto from, auto&& worth) {
    const auto less = [&](const ManifoldPoint& p, const ManifoldPoint& q) { return worth(p) < worth(q); };
    if (from < end) std::iter_swap(from, std::max_element(from, end, less));
  };
  put_first(begin, [&](const ManifoldPoint& p) { return -height(p); });
  const ManifoldPoint first = *begin;
  put_first(begin + 1, [&](const ManifoldPoint& p) {
    return norm2(p.on_a - first.on_a) / (1.0 + (height(p) - height(first)) / low);
  });
}

/// Of what rolls on to a pose, two points that touch now, the farther ahead of those that do, and two that will then.
void merge_turned(const Pair& pair, const Pose& then, Manifold& turned, Manifold& manifold) {
  constexpr std::uint32_t each = 2;
  constexpr double between_equals = 1e-6;  // of the height then: which of those that touch now comes first
  const auto height = [&](const ManifoldPoint& p) {
    return p.gap + dot(p.normal, then.to_world(pair.at_a.to_local(p.on_a)) - p.on_a);
  };
  put_lowest_first(pair, turned, height);
  const double touches = least_gap(points_of(manifold)) + same_gap * pair.thickness;
  put_lowest_first(pair, manifold, [&](const ManifoldPoint& p) {
    return p.gap > touches ? p.gap : touches + between_equals * height(p);
  });
  const Manifold now = manifold;
  manifold.count = 0;
  const auto add = [&](const ManifoldPoint& p) {
    for (std::uint32_t i = 0; i < manifold.count; i++)
      if (manifold.points[i].id == p.id) return;
    if (manifold.count < 2 * each) manifold.points[manifold.count++] = p;
  };
  for (std::uint32_t i = 0; i < std::min(each, now.count); i++) add(now.points[i]);
  for (std::uint32_t i = 0; i < std::min(each, turned.count); i++) add(turned.points[i]);
  for (std::uint32_t i = each; i < now.count; i++) add(now.points[i]);
}

}  // namespace

void add_turned(const Pair& pair, const ManifoldSink& sink, Manifold& manifold) {
  if (manifold.count == 0) return;
  const Travel motion = sink.motion_even_if_held();
  const Turns turns = turns_past(pair, motion, manifold);
  if (turns == Turns::none) return;
  Pose then = moved(pair.at_a, motion, 1.0);
  SeparationCache cache;
  const Separation gap = separation(pair.a, then, pair.b, pair.at_b, infinity, &cache);
  const Vec3 normal = manifold.points[0].normal;  // of the same face then, on which the other one rolls
  const Vec3 of_face = turns == Turns::a ? normal : then.R * transposed_times(pair.at_a.R, normal);
  if (!(dot(gap.normal, of_face) > 1.0 - same_normal)) return;
  then.x -= gap.normal * (gap.distance - least_gap(points_of(manifold)));
  Manifold turned;
  set_points(pair, then, cache, turned);
  move_back(pair, then, turned);
  if (turned.count == 0) return;
  merge_turned(pair, then, turned, manifold);
  manifold.meeting.reset();
}

bool add_turned(const Pair& pair, const ManifoldSink& sink, std::vector<PartManifold>& found) {
  thread_local Collected turned;
  const Travel motion = sink.motion_even_if_held();
  for (const PartManifold& one : found) {
    if (turns_past(pair, motion, one.manifold) == Turns::none) continue;
    Pose then = moved(pair.at_a, motion, 1.0);
    const auto end = one.manifold.points.begin() + one.manifold.count;
    const ManifoldPoint deepest = *std::min_element(
        one.manifold.points.begin(), end, [](const ManifoldPoint& p, const ManifoldPoint& q) { return p.gap < q.gap; });
    const Core core = core_of(pair.a);
    const Vec3 lowest = then.to_world(support(core, transposed_times(then.R, -deepest.normal)));
    then.x += deepest.normal * dot(deepest.normal, deepest.on_a - lowest);
    turned.clear();
    turned.to = &sink;
    find_on_faces(pair, then, turned);
    for (PartManifold& more : turned.found) {
      move_back(pair, then, more.manifold);
      const auto same =
          std::find_if(found.begin(), found.end(), [&](const PartManifold& f) { return f.part == more.part; });
      if (same == found.end())
        found.push_back(more);
      else
        merge_turned(pair, then, more.manifold, same->manifold);
    }
    return true;
  }
  return false;
}

}  // namespace pantin
