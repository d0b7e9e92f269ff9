// Constraints and hinges that bear only so much.
#include <algorithm>

#include "articulates/articulate.hpp"
#include "world/constrain.hpp"
#include "world/deviation.hpp"
#include "world/editing.hpp"

namespace pantin {

using namespace editing;

namespace {

void require_breaking(const std::string& who, const Breaking& b) {
  require_positive_or_infinite(who, "breaks_at.force", b.force, "N");
  require_positive_or_infinite(who, "breaks_at.torque", b.torque, "N m");
  require_positive_or_infinite(who, "breaks_at.length", b.length, "m");
}

/// What bore too much: [N] or [N m].
template <class Id>
struct Overload {
  Id id;
  double load;
  friend bool operator==(const Overload& o, Id other) { return o.id == other; }
};

template <class Id>
void note(std::vector<Overload<Id>>& list, Id id, double load, bool too_much) {
  if (too_much && std::find(list.begin(), list.end(), id) == list.end()) list.push_back({id, load});
}

struct Overloads {
  std::vector<Overload<ConstraintId>> constraints;
  std::vector<Overload<ParticleId>> hinges;
};

void find_overloads(const World& world, const Articulate& a, Overloads& found) {
  for (const Row& row : a.rows) {
    if (row.kind == RowKind::stiff) continue;  // connections break by themselves
    const double load = norm(row.f) * (row.lever > 0.0 ? row.lever : 1.0);
    if (row.condition < 0) {
      const ParticleId ring = world.points[row.member].particle;
      note(found.hinges, ring, load, load > world.particles[ring].breaks_at.force);
      continue;
    }
    const ConstraintId id = condition(a, row).constraint;
    const Constraint& c = world.constraints[id];
    if (c.ring) {
      note(found.hinges, c.ring, load, load > world.particles[c.ring].breaks_at.torque);
      continue;
    }
    const bool too_long = row.lever == 0.0 && norm(row.d1) > c.breaks_at.length;
    note(found.constraints, id, load, too_long || load > (row.lever > 0.0 ? c.breaks_at.torque : c.breaks_at.force));
  }
}

void break_constraint(World& world, ConstraintId id, double load) {
  const std::int32_t hand = world.constraints[id].hand;
  if (hand >= 0 && world.hands[static_cast<std::size_t>(hand)].grab == id)
    world.hands[static_cast<std::size_t>(hand)].grab = {};
  const bool couple = !world.constraints[id].a && world.constraints[id].kind != ConstraintKind::weld;
  take_out_constraint(world, id,
                      {describe(world, id), next_time(world), text("its load of ", load, couple ? " N m" : " N")});
  world.notices.push_back({Notice::Kind::broke, id, -1, world.constraints.story(id), load});
}

void break_hinge(World& world, ParticleId id, double load) {
  end_ring(world, id, text("its load of ", load));
  world.notices.push_back({Notice::Kind::broke, id, -1, world.particles.story(id), load});
}

}  // namespace

void set_breaks_at(World& world, ConstraintId id, const Breaking& breaks_at) {
  require_unlocked(world, "breaks_at");
  require_breaking(describe(world, id), breaks_at);
  Constraint& c = world.constraints[id];
  if (c.breaks_at.possible() != breaks_at.possible()) touch(world, c);
  c.breaks_at = breaks_at;
}

void set_breaks_at(World& world, ParticleId id, const Breaking& breaks_at) {
  require_unlocked(world, "breaks_at");
  Particle& hinge = world.particles[id];
  require(hinge.is_hinge(), "breaks_at: ", describe(world, id), " is no hinge");
  require_breaking(describe(world, id), breaks_at);
  if (hinge.breaks_at.possible() != breaks_at.possible()) touch(world, id);
  hinge.breaks_at = breaks_at;
}

void set_enabled(World& world, ParticleId id, bool enabled) {
  require_unlocked(world, "enabled");
  Particle& hinge = world.particles[id];
  require(hinge.is_hinge(), "enabled: ", describe(world, id), " is no hinge");
  if (hinge.enabled == enabled) return;
  if (enabled) require_together(world, hinge.points);
  hinge.enabled = enabled;
  for (ConstraintId axis : hinge.axes) set_enabled(world, axis, enabled);
  for (PointId point : hinge.points) world.points[point].row_force = zero3();
  touch(world, id);
}

void break_constraints(World& world) {
  Overloads found;
  for (const auto& articulate : world.articulates)
    if (articulate->breakable) find_overloads(world, *articulate, found);
  for (const auto& overload : found.constraints) break_constraint(world, overload.id, overload.load);
  for (const auto& overload : found.hinges) break_hinge(world, overload.id, overload.load);
}

}  // namespace pantin
