#include <algorithm>
#include <utility>

#include "articulates/build/build.hpp"
#include "articulates/build/tied_things.hpp"
#include "articulates/solve/drift.hpp"
#include "articulates/solve/state.hpp"
#include "edit/common.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "forces/solved.hpp"
#include "step/ledger_posts.hpp"
#include "step/phases.hpp"
#include "world/share_blocks.hpp"

namespace pantin::phases {

namespace {

void read_masses(World& world) {
  world.loose_masses.clear();
  for (std::uint32_t slot : world.loose_points) world.loose_masses.push_back(world.points.at_slot(slot).mass);
}

void save_loose(World& world) {
  world.saved_points.resize(world.loose_points.size());
  share_each(world, world.loose_points.size(),
             [&](std::size_t i) { world.saved_points[i] = world.free_motion[world.loose_points[i]]; });
  world.saved_motion.clear();
  for (std::uint32_t slot : world.loose_bodies) world.saved_motion.push_back(world.motion[slot]);
}

bool is_tied(const World& world, PointId id) {
  if (!world.points.alive(id)) return false;
  const Point& point = world.points[id];
  return !point.constraints.empty() || world.particles[point.particle].joins();
}

/// Whether something is to be found anew that was or is tied, or a body: not where free points were only born or have gone.
bool ties_changed(const World& world) {
  return std::any_of(world.edited_things.begin(), world.edited_things.end(),
                     [&](const EditedThing& t) { return t.body || t.articulate >= 0 || is_tied(world, t.point); });
}

std::string lift_of(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  const std::string moved = text(world.motion_of(id).inertia[0], " kg m² instead");
  if (body.bare) return text(": it has points off an axis about which it has no inertia; it moves with ", moved);
  const double own = body.freedom == Freedom::line ? 0.0 : static_cast<double>(body.moments[0]);
  return text(": its smallest principal inertia is ", own,
              " kg m², too little beside its largest for what is tied; until it is loose it moves with ", moved);
}

/// Names, once, bodies whose inertia had to be lifted.
void tell_lifted(World& world, const std::vector<BodyId>& bodies) {
  BodyId first;
  std::size_t others = 0;
  for (BodyId id : bodies) {
    if (std::exchange(world.bodies[id].lift_told, true)) continue;
    if (first)
      others++;
    else
      first = id;
  }
  if (!first) return;
  const std::string more =
      others == 0 ? "" : text(", and ", others, others == 1 ? " other body" : " other bodies", " likewise");
  log_line(world, "warning", describe(world, first) + lift_of(world, first) + more);
}

void find_changed(World& world) {
  const bool changed = world.topology_changed || world.force_elements_changed || !world.disturbed.empty();
  const bool loose = !world.loose_bodies.empty() || !world.loose_points.empty();
  if (!changed && !loose && !world.ledger.wanted) return;
  const Timed timed(world.profile, Phase::find_articulates);
  const bool topology_changed = world.topology_changed;
  const std::size_t count = world.articulates.size();
  world.unchecked = world.unchecked || topology_changed || world.force_elements_changed;
  if (topology_changed && ties_changed(world)) internal::disturb_sites(world);
  internal::note_edited_sites(world);
  if (world.force_elements_changed) choose_solved(world);
  const InertiaChanges changes = find_tied_things(world, world.articulates, world.loose_bodies, world.loose_points);
  post(world, Source::edit, changes.energy);
  tell_lifted(world, changes.lifted);
  if (world.articulates.size() != count) internal::disturb_sites(world);
  if (topology_changed || world.force_elements_changed) read_masses(world);  // every edit of a mass says so
  save_loose(world);
  begin_ledger(world);
}

/// What an edit left of velocities is made consistent before any force acts.
void make_edited_consistent(World& world) {
  if (!rule_of(world).conserves) return;
  for (const auto& articulate : world.articulates) {
    if (!articulate->edited || articulate->rest.asleep) continue;
    load(*articulate, world, world.settings.gravity);
    const EnergyOfConsistency gave = make_start_consistent(*articulate, world.settings.step, 0.0);
    post(world, Source::edit, gave.tied);
    post(world, Source::limit, gave.stopped);
    for (const Node& n : articulate->nodes) store(n, world);
  }
}

}  // namespace

void find_articulates(World& world) {
  begin_stage(world, 0);
  wake_stirred(world);
  find_changed(world);
  for (const auto& a : world.articulates)
    if (a->length_of_motion && !a->rest.asleep)
      find_length_of_motion(*a, world, world.settings.gravity, world.settings.step);
  make_edited_consistent(world);
}

}  // namespace pantin::phases
