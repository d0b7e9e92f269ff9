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

/// What bore too much.
template <class Id>
struct Overload {
  Id id;
  double load;        ///< [N] or [N m]
  std::string story;  ///< what broke it
  friend bool operator==(const Overload& o, Id other) { return o.id == other; }
};

template <class Id>
void note(std::vector<Overload<Id>>& list, const Overload<Id>& load, bool too_much) {
  if (too_much && std::find(list.begin(), list.end(), load.id) == list.end()) list.push_back(load);
}

struct Overloads {
  std::vector<Overload<ConstraintId>> constraints;
  std::vector<Overload<ParticleId>> hinges;
};

void find_overloads(const World& world, const Articulate& a, Overloads& found) {
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (row.kind == RowKind::stiff) continue;  // connections break by themselves
    const bool couple = row.lever > 0.0;
    const double load = norm(exerted_force(a, k)) * (couple ? row.lever : 1.0);
    const auto story = [&] { return couple ? text("its torque of ", load, " N m") : text("its load of ", load, " N"); };
    if (row.condition < 0) {
      const ParticleId ring = world.points[row.member].particle;
      note(found.hinges, {ring, load, story()}, load > world.particles[ring].breaks_at.force);
      continue;
    }
    const ConstraintId id = condition(a, row).constraint;
    const Constraint& c = world.constraints[id];
    if (c.ring) {
      note(found.hinges, {c.ring, load, story()}, load > world.particles[c.ring].breaks_at.torque);
      continue;
    }
    const double length = couple ? 0.0 : norm(row.d1);
    if (length > c.breaks_at.length)
      note(found.constraints, {id, load, text("its length of ", length, " m")}, true);
    else
      note(found.constraints, {id, load, story()}, load > (couple ? c.breaks_at.torque : c.breaks_at.force));
  }
}

void break_constraint(World& world, const Overload<ConstraintId>& overload) {
  const ConstraintId id = overload.id;
  let_go(world, id);
  take_out_constraint(world, id, {describe(world, id), next_time(world), overload.story});
  world.notices.push_back({Notice::Kind::broke, id, -1, world.constraints.story(id), overload.load});
}

void break_hinge(World& world, const Overload<ParticleId>& overload) {
  end_ring(world, overload.id, overload.story);
  world.notices.push_back({Notice::Kind::broke, overload.id, -1, world.particles.story(overload.id), overload.load});
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
  for (const auto& overload : found.constraints) break_constraint(world, overload);
  for (const auto& overload : found.hinges) break_hinge(world, overload);
}

}  // namespace pantin
