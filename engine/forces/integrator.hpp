#pragma once
// What the integrators are, and how each divides a step; how they move things is in step/drift.cpp.
#include <span>
#include <string>

#include "world/world.hpp"

namespace pantin {

/// A stage of a full sub-step.
struct IntegratorStage {
  double length;  ///< relative to the sub-step; may be negative
  double end;     ///< its end, 0 … 1, where the forces are evaluated
};

struct IntegratorRule {
  Integrator integrator;
  std::span<const IntegratorStage> stages;
  bool kicks = true;       ///< each stage is a drift between two half kicks
  bool backwards = false;  ///< has stages of negative length
  bool divides = false;    ///< `accuracy` may divide its steps
  bool touches = false;    ///< moves what touches
  bool ties = true;        ///< moves what constraints and solved connections tie
  bool conserves = true;   ///< its drifts change no energy but by what is told of them
  /// Why it cannot move this world, empty where it can; null: it can move every world.
  std::string (*refuses)(const World&) = nullptr;
};

const IntegratorRule& rule_of(Integrator integrator);
inline const IntegratorRule& rule_of(const World& world) { return rule_of(world.settings.integrator); }

/// Throws Error where the integrator of the settings cannot move the world, or the accuracy needs another one.
void require_integrator_fits(const World& world);
/// "scene.lua:12: ", where the integrator was set, or "".
std::string place_of_integrator(const World& world);

/// The wanted error [1/s], relative to sizes; `accuracy` must be set.
double wanted_accuracy(const World& world);
/// That of trees, which are moved with it: 0 where they are moved as all else is.
double tree_accuracy(const World& world);

/// Counts that not even the most sub-steps gave the accuracy, but an error of `rate` [1/s], by what: a law or a thing. Warns
/// of the largest.
void tell_unreached(World& world, double rate, const std::string& by);

/// "1.2e-05 of the size per second": an error rate [1/s] as messages tell it.
std::string told_rate(const World& world, double rate);
/// The largest error of those, in the unit of the wanted one; 0 where none was missed.
double worst_missed(const World& world);

/// "; scene.accuracy = 1e-4 would …": what to try where steps are too long. Empty where it is set already.
std::string try_accuracy(const World& world);

/// Stages of the coming step.
std::uint32_t stage_count(const World& world);
/// Sets World::stage to one of them.
void begin_stage(World& world, std::uint32_t stage);
/// Time at a fraction of the step that is being done [s].
double time_within(const World& world, double fraction);
/// The time that the kicks of the present stage are for, [s].
double kick_start(const World& world);
double kick_end(const World& world);

}  // namespace pantin
