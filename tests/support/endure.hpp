#pragma once
// What every scene has to stand, whatever is done to it, measured step by step.
#include <array>
#include <functional>
#include <span>
#include <string>

#include "world/world.hpp"

namespace pantin {

inline constexpr std::array step_lengths = {1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 1000, 1.0 / 4000};

struct Endured {
  double step = 0.0;      ///< [s]
  std::string failure;    ///< World::failure at the end
  bool finite = true;     ///< every position and velocity was a number after every step
  double gap = 0.0;       ///< [m] largest of a constraint after a step that was not a fallback step
  double last_gap = 0.0;  ///< [m] at the end
  double gained = 0.0;    ///< [J] largest gain of energy in a fallback step beyond work from outside
  double closure = 0.0;   ///< of the ledger
  double energy = 0.0;    ///< largest |energy - start - work from outside| / largest kinetic energy
  double kinetic = 0.0;   ///< [J] largest
  std::uint64_t steps = 0, fallbacks = 0, halved = 0;
  double iterations = 0.0;  ///< a step
};

/// Done before every step.
using Action = std::function<void()>;
/// Fills a world, and tells what is to be done in it.
using Scene = std::function<Action(World&)>;

Endured endure(World& world, double time, const Action& action = {});

/// What no scene may break: no failure, nothing that is no number, gaps of 1e-8 `length` [m] after steps that were not
/// fallback steps, a ledger that closes, no energy out of fallback steps. Checked by Catch.
void check_sound(const Endured& run, double length);

/// Endures a scene over `time` [s] at each step, checks that it is sound and whatever else, and prints the counts of
/// fallback and halved steps in one line.
void endure_at(std::span<const double> steps, const std::string& name, double time, double length, const Scene& scene,
               const std::function<void(const World&, const Endured&)>& check = {});

}  // namespace pantin
