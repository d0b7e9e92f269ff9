#include "step/reject.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/solve/sub_steps.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/kick_error.hpp"
#include "step/break_at_once.hpp"
#include "step/touch.hpp"

namespace pantin {

namespace {

void tell_unused(World& world) {
  const std::string what = "scene.accuracy_per = \"step\" does nothing without scene.accuracy";
  const auto told = [&](const LogLine& line) { return line.text == what; };
  if (std::none_of(world.log.begin(), world.log.end(), told)) log_line(world, "warning", what);
}

void keep(const Articulate& a, ArticulateStart& to) {
  to.state = a;
  to.nodes.clear();
  if (a.rest.asleep) to.nodes = a.nodes;
  to.forces.resize(a.rows.size());
  to.offsets.resize(a.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    to.forces[k] = a.rows[k].f;
    to.offsets[k] = a.rows[k].offset;
  }
}

/// The factor, and what was predicted of the forces, is of the step that was rejected.
void put_back(const ArticulateStart& from, Articulate& a) {
  static_cast<ArticulateState&>(a) = from.state;
  if (!from.nodes.empty()) a.nodes = from.nodes;
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    a.rows[k].f = from.forces[k];
    a.rows[k].offset = from.offsets[k];
  }
  a.factor_of = FactorOf::none;
  a.last_h = 0.0;
}

/// Contacts and kicks through rows change the model's momenta before articulates have them.
void keep_tied(World& world) {
  world.tied_starts.clear();
  if (!may_touch(world) && !(world.forces && world.forces->velocity_dependent)) return;
  for (const auto& articulate : world.articulates) {
    if (articulate->rest.asleep) continue;
    for (const Node& n : articulate->nodes) {
      if (n.is_body)
        world.tied_starts.push_back({n.slot, true, world.motion[n.slot].p, world.motion[n.slot].angular});
      else
        world.tied_starts.push_back({n.slot, false, world.free_motion[n.slot].v, zero3()});
    }
  }
}

bool divides(const World& world) { return world.settings.accuracy && rule_of(world).divides && world.forces; }

bool may_be_rejected(const World& world) { return divides(world) && world.sub_steps.count < sub_step_limit; }

}  // namespace

void keep_start(World& world) {
  world.kick_error = 0.0;
  keep_tied(world);
  if (!world.settings.accuracy && world.settings.accuracy_per_step) tell_unused(world);
  const bool kept = may_be_rejected(world) || may_break_at_once(world);
  if (!kept && !world.start) return;
  if (!world.start) world.start = std::make_unique<StepStart>();
  StepStart& s = *world.start;
  s.kept = kept;
  if (!kept) return;
  s.articulates.resize(world.articulates.size());
  for (std::size_t i = 0; i < s.articulates.size(); i++) keep(*world.articulates[i], s.articulates[i]);
  s.ledger = world.ledger;
  s.stats = world.stats;
  s.contacts = world.contacts;
  s.loose_bodies = world.loose_bodies;
  s.work = world.work;
  s.nonconservative_work = world.nonconservative_work;
  s.work_check = world.work_check;
  s.instant = world.instant;
}

void note_error(World& world) {
  if (!world.trouble.empty() || !world.forces) return;
  world.kick_error += kick_error(world) * std::fabs(world.stage.h) / world.settings.step;
  world.kick_error = std::max(world.kick_error, world.forces->notes.jump);
}

namespace {

/// A law may fail where a step that is too long has led.
double error_rate(const World& world) { return world.trouble.empty() ? world.kick_error : infinity; }

/// Errors are wanted by the second: the mean over the last one, or since the start where that is less.
double average_error(World& world) {
  KickNotes& n = world.forces->notes;
  const double step = world.settings.step, most = world.settings.accuracy_per_step ? step : std::max(1.0, step);
  world.error_span = std::min(world.error_span + step, most);
  world.mean_error += (std::min(n.told_in_step, 1e6 / step) - world.mean_error) * step / world.error_span;
  n.jumps = std::min(n.jumps, 1e12 / (step * step)) * (1.0 - step / most) + n.jumps_in_step;
  return world.mean_error + std::sqrt(n.jumps);
}

}  // namespace

void put_start_back(World& world) {
  StepStart& s = *world.start;
  put_back(world);
  for (std::size_t i = 0; i < s.articulates.size(); i++) put_back(s.articulates[i], *world.articulates[i]);
  world.ledger = s.ledger;
  world.stats = s.stats;
  world.contacts = s.contacts;
  world.contacts.stale = true;
  world.loose_bodies = s.loose_bodies;
  world.saved_motion.clear();
  for (const std::uint32_t slot : world.loose_bodies) world.saved_motion.push_back(world.motion[slot]);
  world.work = s.work;
  world.nonconservative_work = s.nonconservative_work;
  world.work_check = s.work_check;
  world.instant = s.instant;
  world.trouble.clear();
  world.kick_error = 0.0;
  forget_rejected(world);
  begin_stage(world, 0);
  if (world.forces) find_forces_again(world);
}

bool misses_accuracy(const World& world) {
  return world.start && world.start->kept && may_be_rejected(world) && error_rate(world) > wanted_accuracy(world);
}

bool is_to_be_done_again(World& world) {
  if (!world.start || !divides(world)) return false;
  const double rate = error_rate(world), wanted = wanted_accuracy(world);
  const bool again = misses_accuracy(world);
  const bool reached = adapt(world.sub_steps, rate, wanted);
  if (again) {
    const std::uint64_t rejected = world.stats.rejected + 1;
    put_start_back(world);
    world.stats.rejected = rejected;
    return true;
  }
  if (!world.trouble.empty()) return false;
  note_swings(world);
  const double told = average_error(world);
  const bool missed = !reached || world.forces->notes.told_late;
  if (missed && told > wanted) tell_unreached(world, told, law_of_worst_error(world));
  return false;
}

}  // namespace pantin
