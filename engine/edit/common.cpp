#include "edit/common.hpp"

#include <algorithm>

#include "edit/edit.hpp"
#include "forces/sleep.hpp"

namespace pantin::internal {

double energy_of(const World& world, BodyId body) {
  const Motion& m = world.motion_of(body);
  return kinetic_energy(m) - m.mass * dot(world.settings.gravity, m.x);
}

double energy_of(const World& world, PointId free_point) {
  const FreeMotion& m = world.motion_of(free_point);
  return world.points[free_point].mass * (0.5 * norm2(m.v) - dot(world.settings.gravity, m.x));
}

double energy_round(const World& world, PointId point) {
  const BodyId body = world.points[point].body;
  return body ? energy_of(world, body) : energy_of(world, point);
}

PointId make_point(World& world, Point row) {
  row.serial = world.next_serial++;
  const PointId point = world.points.add(std::move(row));
  world.free_motion.resize(world.points.slots());
  Particle particle;
  particle.points = {point};
  particle.born = world.time;
  particle.serial = world.next_serial++;
  const ParticleId own = world.particles.add(std::move(particle));
  world.points[point].own = world.points[point].particle = own;
  return point;
}

namespace {

void wake(World& world, PointId id, const Particle& shared) {
  Point& point = world.points[id];
  Particle& own = world.particles[point.own];
  own.asleep_in = {};
  own.color = shared.color;
  own.radius = shared.radius;
  own.look = shared.look;
  own.curves = shared.curves;
  own.family = shared.family;
  own.values = shared.values;
  own.lifetime = std::numeric_limits<double>::infinity();
  point.particle = point.own;
  point.row_force = zero3();
}

}  // namespace

void end_ring(World& world, ParticleId hinge, std::string who) {
  disturb_sites(world);
  mark_edited(world, hinge);
  drop_axes(world, hinge, {});
  const Particle shared = world.particles[hinge];
  for (ConnectionId c : shared.connections) remove(world, c);
  for (PointId p : shared.points) wake(world, p, shared);
  const std::string what = shared.name.empty() ? text("hinge ", shared.serial) : text("hinge '", shared.name, "'");
  disturb_forces_by_death(world, hinge);
  world.particles.remove(hinge, {what, world.time, std::move(who)});
}

void leave_ring(World& world, PointId point, const std::string& who) {
  const ParticleId hinge = world.points[point].particle;
  if (hinge == world.points[point].own) return;
  if (world.particles[hinge].points.size() <= 2) return end_ring(world, hinge, who);
  disturb_sites(world);
  mark_edited(world, hinge);
  drop_axes(world, hinge, world.points[point].body);
  wake(world, point, world.particles[hinge]);
  std::erase(world.particles[hinge].points, point);
}

void erase_point(World& world, PointId point, const std::string& what) {
  const std::vector<ConstraintId> constraints = world.points[point].constraints;
  for (ConstraintId c : constraints)
    if (world.constraints.alive(c)) remove(world, c);  // a join takes what holds it along
  const ParticleId hinge = world.points[point].particle, own = world.points[point].own;
  const std::vector<ConnectionId> connections = world.particles[own].connections;
  for (ConnectionId c : connections) remove(world, c);
  leave_ring(world, point, culprit(world));
  if (hinge != own && !world.particles.alive(hinge))
    notice(world, Notice::Kind::removed, hinge, world.particles.story(hinge));
  if (const EmitterId emitter = world.particles[own].emitter; world.emitters.alive(emitter))
    world.emitters[emitter].count--;
  disturb_forces_by_death(world, own);
  world.particles.remove(own, obituary(world, what));
  world.points.remove(point, obituary(world, what));
}

ConstraintId holder(const Model& model, ParticleId ring) {
  for (PointId p : model.particles[awake(model, ring)].points)
    for (ConstraintId id : model.points[p].constraints)
      if (pins(model.constraints[id])) return id;
  return {};
}

void require_free_of_holders(const World& world, std::string_view call, PointId point, ConstraintId but) {
  const ConstraintId held = holder(world, world.points[point].particle);
  if (!held || held == but) return;
  throw Error(text(call, ": ", describe(world, world.points[point].particle), " is already ",
                   pins(world.constraints[held]), " (", describe(world, held), "); remove that first"));
}

Vec3 present(World& world, const std::function<Vec3(double)>& position) {
  const Lock lock(world);
  return position(world.time);
}

Constraint& of_kinds(World& world, ConstraintId id, std::initializer_list<ConstraintKind> kinds, const char* call) {
  require_unlocked(world, call);
  Constraint& c = world.constraints[id];
  require(std::find(kinds.begin(), kinds.end(), c.kind) != kinds.end(), call, ": ", describe(world, id), " has none");
  wake(world, c);
  return c;
}

}  // namespace pantin::internal
