#include "forces/integrator.hpp"

#include <algorithm>
#include <array>

#include "articulates/solve/sub_steps.hpp"

#include "constraints/kind.hpp"
#include "forces/forces_parts.hpp"
#include "forces/solved.hpp"
#include "laws/draws_noise.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

constexpr double default_tree_accuracy = 1e-6;  // [1/s]

constexpr IntegratorStage whole[] = {{1.0, 1.0}};

/// Suzuki 1990: five second-order steps whose errors of third order cancel, a = 1/(4 - cbrt 4).
constexpr double suzuki = 0.4144907717943757;
constexpr IntegratorStage five[] = {{suzuki, suzuki},
                                    {suzuki, 2.0 * suzuki},
                                    {1.0 - 4.0 * suzuki, 1.0 - 2.0 * suzuki},
                                    {suzuki, 1.0 - suzuki},
                                    {suzuki, 1.0}};
/// Kutta 1901: where the four slopes are taken. The last stage puts them together.
constexpr IntegratorStage four[] = {{0.5, 0.5}, {0.5, 0.5}, {1.0, 1.0}, {1.0, 1.0}};

/// Names the first law for which `is` holds, empty where there is none.
template <class Is>
std::string law_that(const World& world, Is is) {
  std::string found;
  each_force_element(world, [&](const ForceElement& row) {
    if (found.empty() && row.enabled && row.law && is(*row.law)) found = law_in_place(row);
  });
  return found;
}

bool dissipates(const Law& law) {
  return (law.velocity_dependent && !law.workless) || (law.also && dissipates(*law.also));
}

bool is_asked(const World& world, const Connection& c, Solve solve) {
  return c.enabled && c.asked == solve && can_be_solved(world, c);
}

std::string what_dissipates(const World& world) {
  const char* const why = "takes a part of each step backwards in time, so nothing may dissipate: ";
  for (ConstraintId id : world.constraints.ids()) {
    const Constraint& c = world.constraints[id];
    if (!c.enabled) continue;
    if (std::isfinite(c.max_force)) return text(why, describe(world, id), " has a max_force");
    if (std::isfinite(c.max_torque)) return text(why, describe(world, id), " has a max_torque");
    if (has_range(c)) return text(why, describe(world, id), " stops what meets it");
  }
  for (ConnectionId id : world.connections.ids())
    if (is_asked(world, world.connections[id], Solve::at_end))
      return text(why, describe(world, id), " is solved at the end of the step");
  const std::string law = law_that(world, dissipates);
  return law.empty() ? "" : text(why, law, " depends on velocities, and may take energy by it");
}

/// Its steps see noise at three instants with weights of their own, so that it would heat too little.
std::string what_is_tied_or_noisy(const World& world) {
  const char* const why = "moves only what no constraint ties: there is ";
  for (ConstraintId id : world.constraints.ids())
    if (world.constraints[id].enabled) return why + describe(world, id);
  for (ParticleId id : world.particles.ids())
    if (world.particles[id].joins()) return why + describe(world, id);
  for (ConnectionId id : world.connections.ids())
    if (is_asked(world, world.connections[id], Solve::at_middle) ||
        is_asked(world, world.connections[id], Solve::at_end))
      return text(why, describe(world, id), ", which is to be solved with what it ties");
  const std::string law = law_that(world, draws_noise);
  return law.empty() ? "" : text("takes forces in the middle of steps, where noise has no meaning: there is ", law);
}

constexpr std::array<IntegratorRule, integrators.size()> rules = {{
    {.integrator = Integrator::verlet, .stages = whole, .divides = true, .touches = true},
    {.integrator = Integrator::implicit, .stages = whole, .divides = true, .touches = true},
    {.integrator = Integrator::suzuki4, .stages = five, .backwards = true, .refuses = what_dissipates},
    {.integrator = Integrator::rk4,
     .stages = four,
     .kicks = false,
     .ties = false,
     .conserves = false,
     .refuses = what_is_tied_or_noisy},
    {.integrator = Integrator::euler, .stages = whole, .conserves = false},
    {.integrator = Integrator::adaptive, .stages = whole, .divides = true, .touches = true},
}};

}  // namespace

const IntegratorRule& rule_of(Integrator integrator) {
  for (const IntegratorRule& rule : rules)
    if (rule.integrator == integrator) return rule;
  assume(false);
  return rules[0];
}

void require_integrator_fits(const World& world) {
  const IntegratorRule& rule = rule_of(world);
  const std::string why = rule.refuses ? rule.refuses(world) : "";
  require(why.empty(), "scene: the integrator \"", name_of(rule.integrator), "\" ", why);
  require((world.shapes.empty() && !world.solids) || rule.touches, "scene: the integrator \"", name_of(rule.integrator),
          "\" moves nothing that touches; \"verlet\" does");
  require(!world.settings.accuracy || rule.divides,
          "scene: accuracy chooses the sub-steps of \"verlet\"; the integrator \"", name_of(rule.integrator),
          "\" has fixed steps");
}

std::string place_of_integrator(const World& world) {
  return world.integrator_from.empty() ? "" : world.integrator_from + ": ";
}

double wanted_accuracy(const World& world) {
  const double wanted = *world.settings.accuracy;
  return world.settings.accuracy_per_step ? wanted / world.settings.step : wanted;
}

double tree_accuracy(const World& world) {
  if (world.settings.accuracy) return wanted_accuracy(world);
  return world.settings.integrator == Integrator::adaptive ? default_tree_accuracy : 0.0;
}

std::string try_accuracy(const World& world) {
  if (world.settings.accuracy) return {};
  return text("; scene.accuracy = 1e-4 would choose sub-steps by the error that they make",
              rule_of(world).divides ? "" : ", with scene.integrator = \"verlet\"");
}

void tell_unreached(World& world, double rate, const std::string& by) {
  world.stats.unreached++;
  if (rate <= world.stats.worst_unreached) return;
  world.stats.worst_unreached = rate;
  const std::string what = "scene.accuracy is not reached: ";
  std::erase_if(world.log, [&](const LogLine& line) { return line.text.starts_with(what); });
  log_line(world, "warning",
           text(what, sub_step_limit, " sub-steps of a step of ", rounded(world.settings.step), " s leave an error of ",
                told_rate(world, rate), "; ", by, " would need a shorter scene.step"));
}

std::string told_rate(const World& world, double rate) {
  const bool per_step = world.settings.accuracy_per_step;
  const double told = per_step ? rate * world.settings.step : rate;
  return (told < 1.0 ? rounded(told) + " of the size" : "more than the size itself") +
         (per_step ? " per step" : " per second");
}

double worst_missed(const World& world) {
  return std::min(world.stats.worst_unreached, 1.0 / world.settings.step) *
         (world.settings.accuracy_per_step ? world.settings.step : 1.0);
}

std::uint32_t stage_count(const World& world) {
  return world.sub_steps.count * static_cast<std::uint32_t>(rule_of(world).stages.size());
}

void begin_stage(World& world, std::uint32_t index) {
  const auto stages = rule_of(world).stages;
  const std::size_t stage = index % stages.size(), whole = index / stages.size();
  const double before = static_cast<double>(whole), width = 1.0 / world.sub_steps.count;
  StepStage& p = world.stage;
  p.index = index;
  p.full = world.settings.step * width;
  p.h = p.full * stages[stage].length;
  p.from = (before + (stage == 0 ? 0.0 : stages[stage - 1].end)) * width;
  p.to = (before + stages[stage].end) * width;
  p.first = stage == 0;
  p.last = stage + 1 == stages.size();
}

double time_within(const World& world, double fraction) {
  if (fraction == 1.0) return next_time(world);
  return world.time + fraction * (next_time(world) - world.time);
}

double kick_start(const World& world) {
  return rule_of(world).kicks ? time_within(world, world.stage.from) : world.time;
}
double kick_end(const World& world) { return time_within(world, rule_of(world).kicks ? world.stage.to : 1.0); }

}  // namespace pantin
