#include "support/endure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "base/check.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/watch.hpp"

namespace pantin {

Endured endure(World& world, double time, const Action& action) {
  Endured run;
  run.step = world.settings.step;
  const Stats start = world.stats;
  keep_ledger(world);
  while (world.failure.empty() && world.time < time - 0.5 * world.settings.step) {
    if (action) action();
    const std::uint64_t safe = world.stats.fallback_steps;
    const double before =
        energy(world).total() - (world.steps > 0 ? world.work : 0.0);  // counted from the first step on
    step(world);
    run.steps++;
    const Energy now = energy(world);
    run.finite = run.finite && all_finite(world);
    run.kinetic = std::max(run.kinetic, now.kinetic);
    run.last_gap = std::max(world.error.constraint, largest_gap(world));
    if (world.stats.fallback_steps == safe)
      run.gap = std::max(run.gap, run.last_gap);
    else
      run.gained = std::max(run.gained, now.total() - world.work - before);
  }
  run.failure = world.failure;
  const Ledger& ledger = world.ledger;  // what is at rest, or spins alone, posts less than its sums round
  run.closure = ledger.posted > 0.0 ? std::max(0.0, ledger.unexplained - ledger.round_off) / ledger.posted : 0.0;
  run.energy = world.worst.energy;
  run.fallbacks = world.stats.fallback_steps - start.fallback_steps;
  run.halved = world.stats.halved_steps - start.halved_steps;
  run.iterations =
      static_cast<double>(world.stats.newton_iterations - start.newton_iterations) / static_cast<double>(run.steps);
  return run;
}

void check_sound(const Endured& run, double length) {
  CHECK(run.failure == "");
  CHECK(run.finite);
  CHECK(run.gap <= 1e-8 * length);
  CHECK(run.closure <= 1e-10);
  CHECK(run.gained <= 1e-9 * run.kinetic);
}

void endure_at(std::span<const double> steps, const std::string& name, double time, double length, const Scene& scene,
               const std::function<void(const World&, const Endured&)>& check) {
  std::string counts;
  for (const double step : steps) {
    INFO(name << " at 1/" << 1.0 / step << " s");
    World world;
    world.settings.step = step;
    const Action action = scene(world);
    const Endured run = endure(world, time, action);
    check_sound(run, length);
    if (check) check(world, run);
    counts += text(" ", run.fallbacks, "+", run.halved);
  }
  std::cout << name << ", fallback + halved steps:" << counts << "\n";
}

}  // namespace pantin
