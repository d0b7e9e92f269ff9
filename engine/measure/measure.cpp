#include "measure/measure.hpp"

#include <algorithm>
#include <unordered_set>

#include "articulates/articulate.hpp"
#include "base/hash.hpp"
#include "constraints/kind.hpp"
#include "contacts/find.hpp"
#include "contacts/touching.hpp"
#include "forces/forces.hpp"
#include "forces/work_check.hpp"
#include "measure/energy_scale.hpp"

namespace pantin {
namespace {

/// Collects bodies and free points, each once, in the order of meeting.
struct Collect {
  const World& world;
  Things things;
  std::unordered_set<BodyId> bodies;
  std::unordered_set<PointId> points;
  std::unordered_set<GroupId> groups;

  void operator()(std::monostate) {}
  void operator()(BodyId id) {
    (void)world.bodies[id];
    if (bodies.insert(id).second) things.bodies.push_back(id);
  }
  void operator()(PointId id) {
    if (const BodyId body = world.points[id].body) return (*this)(body);
    if (points.insert(id).second) things.free_points.push_back(id);
  }
  void operator()(ParticleId id) {
    for (PointId p : world.particles[awake(world, id)].points) (*this)(p);
  }
  void operator()(ConstraintId id) {
    const Constraint& c = world.constraints[id];
    c.each_point([&](PointId point) { (*this)(point); });
    c.each_body([&](BodyId body) { (*this)(body); });
  }
  void operator()(FamilyId id) {
    for (ParticleId p : world.particles.ids())
      if (world.particles[p].family == id && !world.particles[p].asleep_in) (*this)(p);
  }
  void operator()(ConnectionId id) {
    const Connection& c = world.connections[id];
    for (std::uint32_t i = 0; i < c.count; i++) (*this)(c.particles[i]);
  }
  void operator()(InteractionId id) {
    for (FamilyId family : {world.interactions[id].a, world.interactions[id].b}) (*this)(family);
  }
  void operator()(FieldId id) {
    const Field& f = world.fields[id];
    if (f.family) return (*this)(f.family);
    if (f.group) return (*this)(f.group);
    for (ParticleId p : world.particles.ids()) (*this)(p);
  }
  void operator()(EmitterId id) {
    for (ParticleId p : world.particles.ids())
      if (world.particles[p].emitter == id) (*this)(p);
  }
  void operator()(ShapeId id) {
    if (const BodyId body = world.shapes[id].body) (*this)(body);
  }
  void operator()(GroupId id) {
    const auto& members = world.groups[id].members;
    if (!groups.insert(id).second) return;
    for (const AnyId& member : members)
      if (alive(world, member)) std::visit(*this, member);
  }
};

void add(Energy& e, const Motion& m, Vec3 gravity) {
  e.kinetic += kinetic_energy(m);
  e.potential -= m.mass * dot(gravity, m.x);
}

void add(Energy& e, double mass, const FreeMotion& m, Vec3 gravity) {
  e.kinetic += 0.5 * mass * norm2(m.v);
  e.potential -= mass * dot(gravity, m.x);
}

double ring_gap(const World& world, ParticleId id) {
  const Vec3 centre = position(world, star(world, id));
  double gap = 0.0;
  for (PointId p : world.particles[id].points) gap = std::fmax(gap, norm(position(world, p) - centre));
  return gap;
}

}  // namespace

Things everything(const World& world) {
  Things things;
  things.bodies = world.bodies.ids();
  things.free_points = world.points.ids();
  std::erase_if(things.free_points, [&](PointId p) { return static_cast<bool>(world.points[p].body); });
  return things;
}

Things things_of(const World& world, const AnyId& thing) {
  Collect collect{world, {}, {}, {}, {}};
  std::visit(collect, thing);
  return std::move(collect.things);
}

Things things_of(const World& world, const std::vector<ParticleId>& list) {
  Things things;
  for (ParticleId id : list)
    for (PointId p : world.particles[id].points)
      if (const BodyId body = world.points[p].body)
        things.bodies.push_back(body);
      else
        things.free_points.push_back(p);
  std::sort(things.bodies.begin(), things.bodies.end());
  things.bodies.erase(std::unique(things.bodies.begin(), things.bodies.end()), things.bodies.end());
  return things;
}

Energy energy(const World& world, const Things& things) {
  Energy e;
  for (BodyId id : things.bodies) add(e, world.motion_of(id), world.settings.gravity);
  for (PointId id : things.free_points) add(e, world.points[id].mass, world.motion_of(id), world.settings.gravity);
  return e;
}

Energy mechanical_energy(const World& world) {
  // Every step asks for it, so no list is made.
  Energy e;
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) add(e, world.motion[s], world.settings.gravity);
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body)
      add(e, world.points.at_slot(s).mass, world.free_motion[s], world.settings.gravity);
  return e;
}

Energy energy(const World& world) {
  Energy e = mechanical_energy(world);
  e.potential += law_energy(world);
  return e;
}

Vec3 momentum(const World& world, const Things& things) {
  Vec3 sum = zero3();
  for (BodyId id : things.bodies) sum += world.motion_of(id).p;
  for (PointId id : things.free_points) sum += world.motion_of(id).v * world.points[id].mass;
  return sum;
}

Vec3 angular_momentum(const World& world, const Things& things) {
  Vec3 sum = zero3();
  for (BodyId id : things.bodies) {
    const Motion& m = world.motion_of(id);
    sum += cross(m.x, m.p) + rotate(m.q, m.angular);
  }
  for (PointId id : things.free_points) {
    const FreeMotion& m = world.motion_of(id);
    sum += cross(m.x, m.v) * world.points[id].mass;
  }
  return world.plane.about(sum);
}

double mass(const World& world, const Things& things) {
  double sum = 0.0;
  for (BodyId id : things.bodies) sum += world.motion_of(id).mass;
  for (PointId id : things.free_points) sum += world.points[id].mass;
  return sum;
}

Vec3 contact_force(const World& world, const Contact& contact) {
  return world.stage.h > 0.0 ? contact.total / world.stage.h : zero3();
}

Accuracy accuracy(const World& world) {
  Accuracy a;
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && world.particles.at_slot(s).joins())
      a.hinge_gap = std::fmax(a.hinge_gap, ring_gap(world, world.particles.id_at(s)));
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
    const Constraint& c = world.constraints.at_slot(s);
    if (!world.constraints.alive_at(s) || !c.enabled) continue;
    double& worst = rule_of(c).joins_points ? a.hinge_gap : a.constraint;
    worst = std::fmax(worst, present_gap(world, c));
  }
  a.constraint = std::fmax(a.constraint, a.hinge_gap);
  a.penetration = penetration(world.contacts);
  Energy now = mechanical_energy(world);
  if (acting_now(world)) now.potential += law_energy(world);  // else it is out of the balance until the next step
  if (const double scale = energy_scale(world, now); scale > 0.0 && world.steps > 0)
    a.energy = (std::fabs(now.total() - world.start_energy - world.work) + std::fabs(missed_work(world))) / scale;
  return a;
}

MostSubSteps most_sub_steps(const World& world) {
  MostSubSteps most;
  const auto see = [&](std::uint32_t count, bool is_body, std::uint32_t slot) {
    if (count <= most.count) return;
    most.count = count;
    most.thing.clear();
    if (is_body && world.bodies.alive_at(slot)) most.thing = describe(world, world.bodies.id_at(slot));
    if (!is_body && world.points.alive_at(slot)) most.thing = describe(world, world.points.at_slot(slot).particle);
  };
  for (const auto& articulate : world.articulates)
    see(articulate->sub_steps.count, articulate->nodes[0].is_body, articulate->nodes[0].slot);
  for (std::uint32_t slot : world.loose_bodies) see(world.motion[slot].sub_steps.count, true, slot);
  most.count *= world.sub_steps.count;
  return most;
}

std::uint64_t state_hash(const World& world) {
  Hash hash;
  hash.add(world.time);
  for (BodyId id : world.bodies.ids()) {
    const Motion& m = world.motion_of(id);
    hash.add(m.x);
    for (double c : {m.q.w, m.q.x, m.q.y, m.q.z}) hash.add(c);
    hash.add(m.p);
    hash.add(m.angular);
  }
  for (PointId id : world.points.ids()) {
    if (world.points[id].body) continue;
    hash.add(world.motion_of(id).x);
    hash.add(world.motion_of(id).v);
  }
  return hash.value;
}

Bounds bounds(const World& world, const Things& things) {
  Bounds box;
  for (BodyId id : things.bodies) {
    const Body& body = world.bodies[id];
    if (body.points.empty() && body.shapes.empty()) box.add(world.motion_of(id).x);
    for (PointId p : body.points) box.add(position(world, p));
    for (ShapeId s : body.shapes) box.add(bounds_of(world.shapes[s].geometry, pose_of(world, world.shapes[s])));
  }
  for (PointId p : things.free_points) box.add(position(world, p));
  if (box.empty()) return {zero3(), zero3()};
  return box;
}

}  // namespace pantin
