#include "choreography/bring_back.hpp"

#include <algorithm>
#include <unordered_set>

#include "choreography/copy_by_hand.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "measure/query.hpp"
#include "measure/reach.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr std::size_t most_particles = 200;  // more of them are matter

bool holds_to_world(const Constraint& c) {
  std::size_t ends = 0;
  c.each_point([&](PointId) { ends++; });
  c.each_body([&](BodyId) { ends++; });
  return c.enabled && (ends < 2 || std::ranges::any_of(c.passages(), [](const Passage& p) { return !p.point; }));
}

bool tied_to_world(const World& world, const Things& things) {
  const auto by_constraint = [&](ConstraintId id) { return holds_to_world(world.constraints[id]); };
  const auto by_point = [&](PointId id) {
    return std::ranges::any_of(world.points[id].constraints, by_constraint) ||
           std::ranges::any_of(world.particles[world.points[id].particle].connections, [&](ConnectionId tie) {
             const Connection& c = world.connections[tie];
             return c.enabled && !c.positions.empty();
           });
  };
  return std::ranges::any_of(things.free_points, by_point) || std::ranges::any_of(things.bodies, [&](BodyId id) {
           const Body& body = world.bodies[id];
           return std::ranges::any_of(body.constraints, by_constraint) || std::ranges::any_of(body.points, by_point);
         });
}

Things joined_to(const World& world, BodyId body) {
  const auto& points = world.bodies[body].points;
  return points.empty() ? Things{{body}, {}} : tied_to(world, points[0], true);
}

/// Asks for no memory.
template <class IsFar>
bool any_far(const World& world, IsFar is_far) {
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s) && is_far(world.motion[s].x)) return true;
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body && is_far(world.free_motion[s].x)) return true;
  return false;
}

}  // namespace

std::vector<Things> fallen_out(const World& world, Vec3 middle, double distance, std::size_t most) {
  const auto is_far = [&](Vec3 x) { return norm(x - middle) > distance; };
  const auto body_is_far = [&](BodyId id) { return is_far(world.motion_of(id).x); };
  const auto point_is_far = [&](PointId id) { return is_far(position(world, id)); };
  std::vector<Things> found;
  if (!any_far(world, is_far)) return found;
  std::unordered_set<BodyId> seen_bodies;
  std::unordered_set<PointId> seen_points;
  const auto take = [&](Things things) {
    seen_bodies.insert(things.bodies.begin(), things.bodies.end());
    seen_points.insert(things.free_points.begin(), things.free_points.end());
    if (std::ranges::all_of(things.bodies, body_is_far) && std::ranges::all_of(things.free_points, point_is_far) &&
        !tied_to_world(world, things))
      found.push_back(std::move(things));
  };
  const Things all = everything(world);
  for (const BodyId id : all.bodies)
    if (found.size() < most && body_is_far(id) && !seen_bodies.contains(id)) take(joined_to(world, id));
  if (all.free_points.size() > most_particles) return found;
  for (const PointId id : all.free_points)
    if (found.size() < most && point_is_far(id) && !seen_points.contains(id)) take(tied_to(world, id, true));
  return found;
}

namespace {

/// Nails and rods to the world go along; what else holds to a place of it is refused.
std::vector<ConstraintId> nails_of(const World& world, const Things& things) {
  std::vector<ConstraintId> nails;
  const auto take = [&](const std::vector<ConstraintId>& list) {
    for (const ConstraintId id : list) {
      const Constraint& c = world.constraints[id];
      if (c.hand >= 0 || !holds_to_world(c)) continue;
      require((c.kind == ConstraintKind::nail || c.kind == ConstraintKind::rod) && !c.position.of_time,
              "move: ", describe(world, id), " holds it where it is");
      if (std::ranges::count(nails, id) == 0) nails.push_back(id);
    }
  };
  for (const PointId point : things.free_points) take(world.points[point].constraints);
  for (const BodyId body : things.bodies) {
    take(world.bodies[body].constraints);
    for (const PointId point : world.bodies[body].points) take(world.points[point].constraints);
  }
  return nails;
}

}  // namespace

void bring_back(World& world, const Command& c) {
  require_finite("bring", "position", c.position, "m");
  const Things things = whole_of(world, c);
  const Bounds box = bounds(world, things);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const Vec3 way = world.plane.along(c.position - middle);
  const std::vector<ConstraintId> nails = nails_of(world, things);
  for (const BodyId id : things.bodies) {
    set_position(world, id, world.motion_of(id).x + way);
    set_velocity(world, id, zero3());
    set_spin(world, id, zero3());
  }
  for (const PointId id : things.free_points) {
    set_position(world, id, position(world, id) + way);
    set_velocity(world, id, zero3());
  }
  for (const ConstraintId id : nails) set_position(world, id, world.constraints[id].position.now + way);
}

}  // namespace pantin
