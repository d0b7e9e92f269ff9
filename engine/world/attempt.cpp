#include "world/attempt.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/sub_steps.hpp"
#include "world/forces.hpp"
#include "world/integrator.hpp"
#include "world/step_error.hpp"

namespace pantin {

double wanted_accuracy(const World& world) {
  const double wanted = *world.settings.accuracy;
  return world.settings.accuracy_per_step ? wanted / world.settings.step : wanted;
}

void keep_start(World& world) {
  world.kick_error = 0.0;
  if (!world.settings.accuracy || !rule_of(world).divides || !world.forces) {
    if (world.start) world.start->kept = false;
    return;
  }
  if (!world.start) world.start = std::make_unique<StepStart>();
  StepStart& s = *world.start;
  s.kept = world.sub_steps.count < sub_step_limit;
  if (!s.kept) return;
  s.articulates.resize(world.articulates.size());
  for (std::size_t i = 0; i < s.articulates.size(); i++) s.articulates[i] = *world.articulates[i];
  s.ledger = world.ledger;
  s.stats = world.stats;
  s.work = world.work;
  s.open_work = world.open_work;
  s.open_work_check = world.open_work_check;
  s.instant = world.instant;
}

void note_error(World& world) {
  if (world.trouble.empty()) world.kick_error += kick_error(world) * std::fabs(world.part.h) / world.settings.step;
}

namespace {

/// A law may fail where a step that is too long has led.
double error_rate(const World& world) { return world.trouble.empty() ? world.kick_error : infinity; }

/// Errors are wanted by the second: the mean over the last one, or since the start where that is less.
void average_error(World& world, double rate) {
  const double step = world.settings.step, most = world.settings.accuracy_per_step ? step : std::max(1.0, step);
  world.error_span = std::min(world.error_span + step, most);
  world.mean_error += (std::min(rate, 1e6 / step) - world.mean_error) * step / world.error_span;
}

void begin_again(World& world) {
  StepStart& s = *world.start;
  put_back(world);
  for (std::size_t i = 0; i < s.articulates.size(); i++) *world.articulates[i] = s.articulates[i];
  const std::uint64_t rejected = world.stats.rejected + 1;
  world.ledger = s.ledger;
  world.stats = s.stats;
  world.stats.rejected = rejected;
  world.work = s.work;
  world.open_work = s.open_work;
  world.open_work_check = s.open_work_check;
  world.instant = s.instant;
  world.trouble.clear();
  world.kick_error = 0.0;
  forget_attempt(world);
  begin_part(world, 0);
  find_forces_again(world);
}

}  // namespace

bool misses_accuracy(const World& world) {
  return world.start && world.start->kept && world.sub_steps.count < sub_step_limit &&
         error_rate(world) > wanted_accuracy(world);
}

bool is_to_be_done_again(World& world) {
  if (!world.settings.accuracy || !world.start || !rule_of(world).divides || !world.forces) return false;
  const double rate = error_rate(world), wanted = wanted_accuracy(world);
  const bool again = misses_accuracy(world);
  const bool reached = adapt(world.sub_steps, rate, wanted);
  if (again) {
    begin_again(world);
    return true;
  }
  if (!world.trouble.empty()) return false;
  note_swings(world);
  average_error(world, world.forces->notes.told_in_step);
  if (!reached && world.mean_error > wanted) tell_unreached(world, world.mean_error, law_of_worst_error(world));
  return false;
}

}  // namespace pantin
