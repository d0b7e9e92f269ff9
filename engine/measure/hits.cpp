#include "measure/hits.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "contacts/find.hpp"
#include "shapes/ray.hpp"
#include "world/checks.hpp"

namespace pantin {
namespace {

/// With bounds that all shapes are within now, but for what is solid below height fields. The next step goes on as if nothing
/// had been asked: from where shapes were when they moved last, with contacts found anew only where an edit changed something.
const ContactFinder& current_finder(World& world) {
  const bool edited = world.places_changed;
  if (renew(world.contact_finder, world) || world.contact_finder->displaced) {
    ContactFinder& finder = *world.contact_finder;
    finder.asked_changed = finder.asked_changed || finder.changed;
    finder.asked_displaced = finder.asked_displaced || finder.displaced;
    const auto kept = std::tuple(finder.shapes_now, finder.points_now, finder.going);
    const bool was_changed = finder.changed;
    put_bounds({world, world.articulates, world.contacts, false, world.settings.gravity, world.settings.step}, finder);
    if (!was_changed) std::tie(finder.shapes_now, finder.points_now, finder.going) = kept;
    world.contacts.stale = world.contacts.stale || edited;
  }
  return *world.contact_finder;
}

bool counts(const HitFilter& filter, const Shape& shape, ShapeId id) {
  if (shape.sensor && !filter.sensors) return false;
  if (!filter.any_layer && !std::binary_search(filter.layers.begin(), filter.layers.end(), shape.layer)) return false;
  return std::none_of(filter.ignored.begin(), filter.ignored.end(), [&](const AnyId& thing) {
    return thing == AnyId(id) || (shape.body && thing == AnyId(shape.body));
  });
}

/// Those that are found by `meet(shape, pose)` among the shapes that `each(broad phase, use)` calls `use` with, and height
/// fields.
template <class Each, class Meet>
std::vector<Hit> collect(const World& world, const ContactFinder& finder, const HitFilter& filter, Each each,
                         Meet meet) {
  std::vector<Hit> hits;
  const auto try_at = [&](std::uint32_t slot) {
    const ShapeId id = world.shapes.id_at(slot);
    const Shape& shape = world.shapes[id];
    if (!counts(filter, shape, id)) return;
    if (std::optional<Hit> hit = meet(shape, pose_of(world, shape))) {
      hit->shape = id;
      hits.push_back(*hit);
    }
  };
  const auto& fields = finder.height_fields;
  each(finder.broad_phase, [&](std::uint32_t slot) {
    if (!std::binary_search(fields.begin(), fields.end(), slot)) try_at(slot);
  });
  for (const std::uint32_t slot : fields) try_at(slot);
  std::sort(hits.begin(), hits.end(), [&](const Hit& x, const Hit& y) {
    if (x.distance != y.distance) return x.distance < y.distance;
    return world.shapes[x.shape].serial < world.shapes[y.shape].serial;
  });
  return hits;
}

std::optional<Hit> hit_at(const std::optional<RayHit>& met, Vec3 from, Vec3 way) {
  if (!met) return {};
  return Hit{{}, from + way * met->part, met->normal, norm(way) * met->part};
}

/// So long that a ray in a direction of unit length has passed a shape, or met a half space [m].
double length_past(const Shape& shape, const Pose& pose, Vec3 from, Vec3 direction) {
  const double to_centre = norm(pose.x - from);
  if (!std::holds_alternative<HalfSpaceShape>(shape.geometry)) return to_centre + reach_of(shape.geometry);
  const double height = dot(pose.R[2], from - pose.x), falling = -dot(pose.R[2], direction);
  return falling > 0.0 && height > 0.0 ? 2.0 * height / falling : 1.0;
}

/// Keeps the deepest point.
struct Deepest final : ManifoldSink {
  std::optional<ManifoldPoint> point;
  void take(const Manifold& m, std::uint32_t) override {
    for (std::uint32_t i = 0; i < m.count; i++)
      if (!point || m.points[i].gap < point->gap) point = m.points[i];
  }
};

Bounds only(Vec3 x) {
  Bounds bounds;
  bounds.add(x);
  return bounds;
}

}  // namespace

std::vector<Hit> hits_of_ray(World& world, Vec3 from, Vec3 to, const HitFilter& filter) {
  internal::require_finite("ray", "from", from, "m");
  internal::require_finite("ray", "to", to, "m");
  const ContactFinder& finder = current_finder(world);
  const Vec3 way = to - from;
  return collect(
      world, finder, filter, [&](const BroadPhase& bounds, auto use) { bounds.along(only(from), way, use); },
      [&](const Shape& shape, const Pose& pose) { return hit_at(ray(shape.geometry, pose, from, to), from, way); });
}

std::vector<Hit> hits_of_endless_ray(World& world, Vec3 from, Vec3 along, const HitFilter& filter) {
  internal::require_finite("ray", "from", from, "m");
  internal::require_finite("ray", "direction", along, "");
  const double longest = largest(along);
  require(longest > 0.0, "ray: direction must have a length > 0");
  const ContactFinder& finder = current_finder(world);
  constexpr double endless = 1e15;            // [m]
  const Vec3 u = direction(along / longest);  // of any size
  return collect(
      world, finder, filter, [&](const BroadPhase& bounds, auto use) { bounds.along(only(from), u * endless, use); },
      [&](const Shape& shape, const Pose& pose) {
        const Vec3 way = u * length_past(shape, pose, from, u);
        return hit_at(ray(shape.geometry, pose, from, from + way), from, way);
      });
}

std::vector<Hit> hits_of_cast(World& world, const Geometry& convex, const Pose& pose, Vec3 way,
                              const HitFilter& filter) {
  internal::require_finite("cast", "from", pose.x, "m");
  internal::require_finite("cast", "the way", way, "m");
  require(is_convex(convex), "cast: what moves must be convex: no plane, mesh or heights");
  const ContactFinder& finder = current_finder(world);
  return collect(
      world, finder, filter,
      [&](const BroadPhase& bounds, auto use) { bounds.along(bounds_of(convex, pose), way, use); },
      [&](const Shape& shape, const Pose& at) -> std::optional<Hit> {
        const std::optional<RayHit> met = cast(convex, pose, way, shape.geometry, at);
        if (!met) return {};
        const Pose there = {pose.x + way * met->part, pose.R};
        const Vec3 into = transposed_times(pose.R, -met->normal);
        const Vec3 touching = there.to_world(support_of_core(convex, into)) - met->normal * rounding_of(convex);
        return Hit{{}, touching, met->normal, norm(way) * met->part};
      });
}

std::vector<Hit> overlapping(World& world, const Geometry& convex, const Pose& pose, const HitFilter& filter) {
  internal::require_finite("overlap", "at", pose.x, "m");
  require(is_convex(convex), "overlap: what overlaps must be convex: no plane, mesh or heights");
  const ContactFinder& finder = current_finder(world);
  return collect(
      world, finder, filter, [&](const BroadPhase& bounds, auto use) { bounds.in_box(bounds_of(convex, pose), use); },
      [&](const Shape& shape, const Pose& at) -> std::optional<Hit> {
        if (!overlaps(convex, pose, shape.geometry, at)) return {};
        if (is_convex(shape.geometry)) {
          const Separation s = separation(convex, pose, shape.geometry, at, 0.0);
          return Hit{{}, s.on_a, s.normal, std::min(0.0, s.distance)};
        }
        Deepest deepest;
        SeparationCache cache;
        find_manifolds(convex, pose, shape.geometry, at, 0.0, cache, deepest);
        if (!deepest.point) return Hit{{}, pose.x, zero3(), 0.0};
        return Hit{{}, deepest.point->on_a, deepest.point->normal, std::min(0.0, deepest.point->gap)};
      });
}

std::vector<Hit> containing(World& world, Vec3 at, const HitFilter& filter) {
  internal::require_finite("inside", "the position", at, "m");
  const ContactFinder& finder = current_finder(world);
  return collect(
      world, finder, filter, [&](const BroadPhase& bounds, auto use) { bounds.in_box(only(at), use); },
      [&](const Shape& shape, const Pose& pose) -> std::optional<Hit> {
        if (!inside(shape.geometry, pose, at)) return {};
        return Hit{{}, at, zero3(), 0.0};
      });
}

}  // namespace pantin
