#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "contacts/overlaps.hpp"
#include "contacts/touching.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "forces/work_check.hpp"
#include "measure/energy_scale.hpp"
#include "step/ledger_posts.hpp"
#include "step/phases.hpp"
#include "step/share.hpp"

namespace pantin::phases {

namespace {

/// A position that is a number, and a kinetic energy that is one.
bool sound(Vec3 position, const Quat& q, double kinetic) {
  return finite(position) && std::isfinite(q.w + q.x + q.y + q.z) && std::isfinite(kinetic);
}

struct OfLoosePoints {
  double kinetic = 0.0;          ///< [J]
  Vec3 mass_position = zero3();  ///< [kg m] sum of mass times position
  bool finite = true;            ///< these sums are; then all states are
};

OfLoosePoints measure_loose_points(const World& world) {
  Vec3 kinetic = zero3(), mass_position = zero3(), unsound = zero3();
  for (std::size_t i = 0; i < world.loose_points.size(); i++) {
    const FreeMotion& m = world.free_motion[world.loose_points[i]];
    kinetic += m.v * m.v * world.loose_masses[i];
    mass_position += m.x * world.loose_masses[i];
    unsound += m.x * 0.0;
  }
  const double sum = 0.5 * (kinetic[0] + kinetic[1] + kinetic[2]);
  return {sum, mass_position, std::isfinite(sum) && finite(unsound)};
}

/// The first thing whose new state is not finite; monostate if all is well.
AnyId first_bad(const World& world, const OfLoosePoints& points) {
  for (std::size_t i = 0; !points.finite && i < world.loose_points.size(); i++) {
    const std::uint32_t slot = world.loose_points[i];
    const FreeMotion& m = world.free_motion[slot];
    if (!sound(m.x, {}, norm2(m.v))) return world.points.at_slot(slot).particle;
  }
  for (std::uint32_t slot : world.loose_bodies) {
    const Motion& m = world.motion[slot];
    if (!sound(m.x, m.q, kinetic_energy(m))) return world.bodies.id_at(slot);
  }
  for (const auto& articulate : world.articulates) {
    if (articulate->totals.finite) continue;
    for (const Node& n : articulate->nodes)
      if (!sound(n.x0, n.q0, kinetic_energy(n)))
        return n.is_body ? AnyId(world.bodies.id_at(n.slot)) : AnyId(world.points.at_slot(n.slot).particle);
  }
  return {};
}

/// What an act made of a thing at the start of the step that no step is short enough for; empty: nothing.
std::string beyond_numbers(const World& world, const AnyId& thing) {
  const double h = world.settings.step;
  const auto told = [](const char* does, Vec3 what, const char* unit) {
    return text(does, rounded(std::hypot(what[0], what[1], what[2])), unit, " and has an energy beyond all numbers");
  };
  const auto of = [&](double mass, Vec3 velocity, Vec3 push) {
    const auto beyond = [&](Vec3 v) { return norm2(v) > 0.0 && !std::isfinite(mass * norm2(v)); };
    if (beyond(velocity)) return told("it moves at ", velocity, " m/s");
    return beyond(push * (h / mass)) ? told("it is pushed by ", push, " N") : "";
  };
  if (const auto* particle = std::get_if<ParticleId>(&thing)) {
    const PointId point = world.particles[*particle].points[0];
    return of(world.points[point].mass, velocity(world, point), world.points[point].force);
  }
  const Motion& m = world.motion_of(std::get<BodyId>(thing));
  if (const std::string moved = of(m.mass, m.p / m.mass, m.force); !moved.empty()) return moved;
  const auto beyond = [&](Vec3 angular) { return !std::isfinite(dot(angular, inverse_inertia(m) * angular)); };
  if (beyond(m.angular)) return told("it turns with an angular momentum of ", m.angular, " kg m²/s");
  return beyond(m.torque * h) ? told("it is twisted by ", m.torque, " N m") : "";
}

std::string last_act(const World& world) {
  if (world.last_actor.empty()) return {};
  return text("; the last to act on the scene was ", world.last_actor, ", at ", world.last_act, " s");
}

/// Puts the last good state back, and tells the first law that gave a force, or the first thing whose state, is not
/// finite; empty if all is well.
std::string undo_what_went_bad(World& world, const OfLoosePoints& points, double time) {
  const AnyId bad = first_bad(world, points);
  const bool all_well = std::holds_alternative<std::monostate>(bad);
  const Forces* forces = world.forces.get();
  const bool energy_lost = forces && forces->told && !std::isfinite(forces->energy);
  if (all_well && !energy_lost && world.trouble.empty()) return {};
  put_back(world);
  for (const auto& articulate : world.articulates)
    if (std::exchange(articulate->stored, false)) take_back(*articulate, world);
  if (all_well && !energy_lost) return world.trouble;
  if (std::string law = bad_force(world); !law.empty()) return law;
  if (all_well) return text("the energy of the laws is not a finite number", try_accuracy(world));
  const std::string what =
      text("the state of ", describe(world, bad), " is no longer a finite number at ", time, " s: ");
  if (const std::string beyond = beyond_numbers(world, bad); !beyond.empty()) return what + beyond;
  return text(what, "forces or speeds are too large for a step of ", world.settings.step, " s", try_accuracy(world));
}

void end_pushes(World& world) {
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) world.motion[s].force = world.motion[s].torque = zero3();
  for (std::uint32_t s = 0; s < world.points.slots(); s++) world.points.at_slot(s).force = zero3();
  world.pushed = false;
}

/// Energies and gaps from the working copies, which are at hand; `accuracy()` finds the same from the model's rows.
void measure_errors(World& world, const OfLoosePoints& points) {
  const Vec3 gravity = world.settings.gravity;
  double kinetic = points.kinetic;
  double potential = -dot(gravity, points.mass_position + world.contacts.slept_position);
  Accuracy now;
  for (const auto& articulate : world.articulates) {
    kinetic += articulate->totals.kinetic;
    potential -= dot(gravity, articulate->totals.mass_position);
    now.hinge_gap = std::max(now.hinge_gap, articulate->gaps.points);
    now.constraint = std::max(now.constraint, articulate->gaps.all());
  }
  for (std::uint32_t slot : world.loose_bodies) {
    const Motion& m = world.motion[slot];
    kinetic += kinetic_energy(m);
    potential -= m.mass * dot(gravity, m.x);
  }
  world.largest_kinetic = std::max(world.largest_kinetic, kinetic);
  now.energy = world.error.energy;
  const bool acting = acting_now(world), told = !acting || world.forces->told;
  if (acting && told) potential += world.forces->energy;
  const double scale = energy_scale(world, {kinetic, potential});
  if (told && scale > 0.0) {
    const double wrong =
        std::fabs(kinetic + potential - world.start_energy - world.work) + std::fabs(missed_work(world));
    world.worst_energy = std::max(world.worst_energy, wrong);
    now.energy = wrong / scale;
    world.worst.energy = world.worst_energy / scale;
  }
  now.penetration = penetration(world.contacts);
  world.worst.penetration = std::max(world.worst.penetration, now.penetration);
  world.worst.hinge_gap = std::max(world.worst.hinge_gap, now.hinge_gap);
  world.worst.constraint = std::max(world.worst.constraint, now.constraint);
  world.error = now;
  if (now.penetration > 0.0) note_deepest(world, world.contacts, world.time);
}

/// Names, once and a few of a scene, what overlaps where it was put and cannot leave, as a lever whose hinge is within a wall.
void tell_stuck(World& world) {
  const std::vector<Stuck> stuck = take_stuck(world, world.contacts, world.steps);
  if (stuck.empty()) return;
  constexpr std::ptrdiff_t few = 5;
  constexpr std::string_view since = " m since it was put there";
  const std::string what =
      text(describe(world, stuck[0].pair.a), " overlaps ", describe(world, stuck[0].pair.b), " by ");
  const auto is_told = [&](const LogLine& line) { return line.text.starts_with(what); };
  const auto is_such = [&](const LogLine& line) { return line.text.find(since) != std::string::npos; };
  if (std::any_of(world.log.begin(), world.log.end(), is_told)) return;
  if (std::count_if(world.log.begin(), world.log.end(), is_such) >= few) return;
  const std::size_t more = stuck.size() - 1;
  log_line(world, "warning",
           text(what, rounded(stuck[0].depth), since, ", and nothing can push it out",
                more == 0   ? std::string()
                : more == 1 ? std::string("; so it is with 1 more pair")
                            : text("; so it is with ", more, " more pairs"),
                ". Put it elsewhere, or let it through: give the two layers and say scene:collide(\"a\", \"b\", "
                "false); what shares a hinge passes through each other, too"));
}

void tell_touch(World& world) {
  const auto tell = [&](Notice::Kind kind, const Touch& touch) {
    Notice notice;
    notice.kind = kind;
    notice.thing = touch.pair.a;
    notice.touch = touch;
    world.notices.push_back(std::move(notice));
  };
  const TouchChanges changes = take_changes(world, world.contacts);
  for (const TouchPair& pair : changes.parted) tell(Notice::Kind::parted, {pair});
  for (const Touch& touch : changes.touched) tell(Notice::Kind::touched, touch);
}

}  // namespace

void end_step(World& world) {
  const Timed timed(world.profile, Phase::end_step);
  const double time = next_time(world);
  const OfLoosePoints points = measure_loose_points(world);
  share_articulates(world, [](Articulate& articulate, int) {
    if (!articulate.rest.asleep && !articulate.stored) articulate.totals = totals_of(articulate);
  });
  if (const std::string bad = undo_what_went_bad(world, points, time); !bad.empty()) {
    world.failure =
        text(bad, "; the scene is stopped at its last good state", world.trouble.empty() ? last_act(world) : "");
    log_line(world, "failure", world.failure);
    return;
  }
  share_articulates(world, [&](Articulate& articulate, int) {
    if (!articulate.rest.asleep && !std::exchange(articulate.stored, false)) store(articulate, world);
  });
  fall_asleep(world);
  world.time = time;
  world.step_count++;
  world.steps++;
  if (world.pushed) end_pushes(world);
  end_ledger(world);
  measure_errors(world, points);
  if (!world.contacts.put.empty()) tell_stuck(world);
  if (world.contacts.watched) tell_touch(world);
  for (Probe& probe : world.probes) probe.latest = probe.read();  // one that fails leaves no row half recorded
  for (Probe& probe : world.probes) probe.values.push_back(probe.latest);
}

}  // namespace pantin::phases
