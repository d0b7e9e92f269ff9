#include "edit/parts.hpp"

#include <algorithm>
#include <unordered_set>

#include "articulates/solve/state.hpp"

namespace pantin::internal {

Totals totals_of(const World& world, std::span<const BodyId> bodies, std::span<const PointId> free_points) {
  Totals t;
  const Vec3 first = bodies.empty() ? world.motion_of(free_points[0]).x : world.motion_of(bodies[0]).x;
  Vec3 moment = zero3();
  const auto add_mass = [&](double mass, Vec3 x, Vec3 p) {
    t.mass += mass;
    moment += (x - first) * mass;
    t.p += p;
  };
  for (BodyId id : bodies) add_mass(world.motion_of(id).mass, world.motion_of(id).x, world.motion_of(id).p);
  for (PointId id : free_points) {
    const double mass = world.points[id].mass;
    add_mass(mass, world.motion_of(id).x, world.motion_of(id).v * mass);
  }
  t.centre = first + moment / t.mass;
  for (BodyId id : bodies) {
    const Motion& m = world.motion_of(id);
    t.angular += cross(m.x - t.centre, m.p) + rotate(m.q, m.angular);
  }
  for (PointId id : free_points)
    t.angular += cross(world.motion_of(id).x - t.centre, world.motion_of(id).v) * world.points[id].mass;
  t.angular = world.plane.about(t.angular);
  return t;
}

void set_momenta(World& world, BodyId body, Vec3 p, Vec3 angular) {
  Motion& m = world.motion_of(body);
  m.p = p;
  m.angular = turning_part(m, angular);
}

void part_ties_within(World& world, std::span<const PointId> points, const std::string& who) {
  const std::unordered_set<PointId> all(points.begin(), points.end());
  std::unordered_set<ParticleId> rings;
  for (PointId id : points) {
    const std::vector<ConstraintId> constraints = world.points[id].constraints;
    for (ConstraintId c : constraints) {
      if (!world.constraints.alive(c)) continue;
      int inside = 0, outside = 0;
      const Constraint& row = world.constraints[c];
      row.each_point([&](PointId p) { (all.contains(p) ? inside : outside)++; });
      for (const Passage& passage : row.passages()) outside += passage.point ? 0 : 1;
      for (const CoupledValue& v : row.coupled()) outside += v.point_a && v.point_b ? 0 : 1;
      if (inside > 1 && outside == 0) remove(world, c);
    }
    const ParticleId ring = world.points[id].particle;
    if (ring == world.points[id].own || rings.insert(ring).second) continue;
    const std::string what = describe(world, ring);
    leave_ring(world, id, who);
    notice(world, Notice::Kind::cut, ring,
           world.particles.alive(ring) ? text(describe(world, id), " left ", what, " by ", who)
                                       : world.particles.story(ring));
  }
}

BodyId make_body(World& world, std::string name, Vec3 at, const Quat& frame, std::vector<PointId> points) {
  Body row;
  row.name = std::move(name);
  row.serial = world.next_serial++;
  row.points = std::move(points);
  const BodyId id = world.bodies.add(std::move(row));
  world.motion.resize(world.bodies.slots());
  world.motion_of(id) = Motion{};
  world.motion_of(id).x = at;
  world.motion_of(id).q = frame;
  for (PointId p : world.bodies[id].points) world.points[p].body = id;
  return id;
}

void drop_rotations(World& world, BodyId id) {
  const std::vector<ConstraintId> constraints = world.bodies[id].constraints;
  for (ConstraintId c : constraints) {
    if (!world.constraints.alive(c)) continue;
    if (const ParticleId ring = world.constraints[c].ring())
      drop_axes(world, ring, id);
    else
      remove(world, c);
  }
}

void erase_body(World& world, BodyId id, const std::string& who) {
  drop_rotations(world, id);
  erase_shapes(world, id, who);
  world.bodies.remove(id, {describe(world, id), world.time, who});
  world.motion[id.slot - 1] = Motion{};
  notice(world, Notice::Kind::removed, id, world.bodies.story(id));
}

}  // namespace pantin::internal
