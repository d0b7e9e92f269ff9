// `pantin bench accuracy`: gaps, energy and distance from an independent reference, of the hard cases over 5 s.
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "player/bench.hpp"
#include "step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"
#include "world/measure.hpp"

namespace pantin {

namespace {

struct HardCase {
  std::string name;
  std::function<BodyId(World&)> make;       ///< returns the last body
  std::function<Eigen::Vector2d()> at_one;  ///< place of its centre at 1 s from the reference [m], or empty
};

Eigen::Vector2d last_centre(const reference::PlaneChain& chain) {
  const int last = static_cast<int>(chain.links.size()) - 1;
  return reference::centre(chain, reference::advance(chain, 1.0, 200), last);
}

std::vector<HardCase> hard_cases() {
  const auto chain = [](int links) {
    return [links](World& world) { return cases::add_chain(world, {.links = links}).bodies.back(); };
  };
  const auto heavy = [](int links, double ratio) {
    return [=](World& world) { return cases::add_heavy_chain(world, links, ratio).bodies.back(); };
  };
  return {
      {"chain(1)", chain(1), [] { return last_centre(reference::plane_chain(1)); }},
      {"chain(10)", chain(10), [] { return last_centre(reference::plane_chain(10)); }},
      {"chain(100)", chain(100), nullptr},
      {"heavy(10), 1e3", heavy(10, 1e3), [] { return last_centre(reference::heavy_plane_chain(10, 1e3)); }},
      {"heavy(10), 1e6", heavy(10, 1e6), nullptr},
      {"heavy(100), 1e6", heavy(100, 1e6), nullptr},
      {"ring(24)", [](World& world) { return cases::add_ring(world, 24).bodies.back(); }, nullptr},
  };
}

struct Outcome {
  double gap, energy, error;  ///< [m], relative to the largest kinetic energy, [m]
  std::uint64_t halved, safe;
};

Outcome outcome(const HardCase& hard, double rate, bool energy_return, const Eigen::Vector2d* reference) {
  World world;
  world.settings.step = 1.0 / rate;
  world.settings.energy_return = energy_return;
  const BodyId last = hard.make(world);
  double error = -1.0;
  const auto one = static_cast<std::uint64_t>(rate);
  const Watched course = watch(world, 5.0, [&] {
    if (reference && world.steps == one) error = norm(world.motion_of(last).x - vec(reference->x(), reference->y(), 0));
  });
  return {course.gap, course.energy_error(), error, world.stats.halved_steps, world.stats.safe_steps};
}

void run(const player::BenchOptions&) {
  std::printf("5 s from horizontal; error: last body's centre at 1 s from minimal coordinates, to round-off\n");
  std::printf("%-16s %7s %10s %12s %12s %12s %7s %5s\n", "case", "step", "gap, m", "energy", "... without", "error, m",
              "halved", "safe");
  for (const HardCase& hard : hard_cases()) {
    Eigen::Vector2d place;
    if (hard.at_one) place = hard.at_one();
    for (const double rate : {60.0, 240.0, 1000.0}) {
      const Outcome with = outcome(hard, rate, true, hard.at_one ? &place : nullptr);
      const Outcome without = outcome(hard, rate, false, nullptr);
      std::printf("%-16s 1/%-5g %10.1e %12.1e %12.1e ", hard.name.c_str(), rate, with.gap, with.energy, without.energy);
      if (with.error < 0.0)
        std::printf("%12s", "-");
      else
        std::printf("%12.2e", with.error);
      std::printf(" %7llu %5llu\n", static_cast<unsigned long long>(with.halved),
                  static_cast<unsigned long long>(with.safe));
    }
  }
  std::printf("energy: largest change relative to the largest kinetic energy, with and without the energy return\n");
}

const player::Register registered({"accuracy", "gaps, energy and error of chains, heavy chains and a ring", run});

}  // namespace

}  // namespace pantin
