// The hinges that joins make once their points have met.
#include "choreography/joins_that_met.hpp"

#include "articulates/articulate.hpp"
#include "choreography/choreography.hpp"
#include "constraints/kind.hpp"
#include "edit/assemble.hpp"
#include "edit/common.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr double near = 0.01;     // of the size of their bodies: from here on a limited join holds as a hinge does
constexpr double nearer = 1e-3;   // relative, that counts as coming nearer
constexpr double patience = 100;  // time constants without any, before it is told

double size_of_pair(const World& world, const Constraint& c) {
  const double size = std::fmax(size_of(world, c.a), size_of(world, c.b));
  return size > 0.0 ? size : largest(position(world, c.a));
}

/// A limited join may be too weak for what holds its points apart.
void tell_when_stuck(World& world, ConstraintId id, double apart) {
  const Constraint& c = world.constraints[id];
  JoinProgress& progress = *c.progress();
  if (apart < progress.nearest * (1.0 - nearer)) {
    progress.nearest = apart;
    progress.nearest_at = world.time;
  }
  if (progress.told || world.time - progress.nearest_at < patience * c.time_constant) return;
  progress.told = true;
  log_line(
      world, "warning",
      text(describe(world, id), progress.label.empty() ? "" : " of ", progress.label,
           ": its points have come no nearer ", "than ", progress.nearest, " m for ", world.time - progress.nearest_at,
           " s; its max_force of ", c.max_force, " N may be less than what pulls them apart"));
}

/// A limited join whose points are near, and not just passing, is one without a limit from now on.
void hold_when_near(World& world, ConstraintId id) {
  Constraint& c = world.constraints[id];
  if (!std::isfinite(c.max_force)) return;
  const double reach = near * size_of_pair(world, c), apart = norm(position(world, c.a) - position(world, c.b));
  if (apart > reach) return tell_when_stuck(world, id, apart);
  if (norm(velocity(world, c.a) - velocity(world, c.b)) * c.time_constant > reach) return;
  c.max_force = std::numeric_limits<double>::infinity();
  start_constraint(world, c);
  mark_edited(world, c);
}

bool has_met(const Constraint& c) {
  return !std::isfinite(c.max_force) && norm2(c.attract.away) == 0.0 && norm2(c.attract.previous_away) == 0.0;
}

/// In the next step, by the choreography: it may be gone by then.
void tell_met(World& world, ParticleId hinge, const JoinProgress& progress) {
  if (!progress.on_met) return;
  Event event;
  event.time = world.time;
  event.target = hinge;
  event.label = progress.label;
  event.action = TellMet{hinge, progress.on_met};
  add_event(world, std::move(event));
}

void make_met_hinge(World& world, ConstraintId id) {
  const Constraint c = world.constraints[id];
  const Acting acting(world);
  world.locked = false;
  world.who = [label = c.progress()->label] { return label.empty() ? std::string("its join") : label; };
  const PointId points[] = {c.a, c.b};
  try {
    HingeDef def;
    def.name = c.progress()->hinge_name;
    if (const Vec3 axis = c.progress()->hinge_axis; norm2(axis) > 0.0) def.axis = axis;
    take_out_constraint(world, id, {describe(world, id), world.time, "its points meeting"});
    const ParticleId hinge = add_hinge(world, points, def);
    notice(world, Notice::Kind::joined, hinge, text(describe(world, hinge), " was made"));
    tell_met(world, hinge, *c.progress());
  } catch (const Error& error) { log_line(world, "dropped", text("join: ", error.what())); }
}

}  // namespace

void make_met_hinges(World& world) {
  std::vector<ConstraintId> met;
  for (const auto& articulate : world.articulates) {
    if (articulate->all_rigid) continue;
    for (const Condition& row : articulate->conditions) {
      if (!world.constraints.alive(row.constraint)) continue;
      const Constraint& c = world.constraints[row.constraint];
      if (!c.progress()) continue;
      hold_when_near(world, row.constraint);
      if (has_met(c)) met.push_back(row.constraint);
    }
  }
  for (ConstraintId id : met)
    if (world.constraints.alive(id)) make_met_hinge(world, id);
}

}  // namespace pantin
