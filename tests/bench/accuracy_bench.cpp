// `pantin bench accuracy`: gaps, energy and distance from an independent reference, of the hard cases over 5 s.
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "articulates/articulate.hpp"
#include "measure/measure.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

struct HardCase {
  std::string name;
  std::function<BodyId(World&)> make;       ///< returns the last body
  std::function<Eigen::Vector2d()> at_one;  ///< position of its centre at 1 s from the reference [m], or empty
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

/// What is done about what the projection of velocities takes.
enum class Balance { returned, carried, plain };

struct Outcome {
  double gap, energy, error;  ///< [m], relative to the largest kinetic energy, [m]
  std::uint64_t halved, safe;
};

Outcome outcome(const HardCase& hard, Integrator integrator, double rate, Balance balance,
                const Eigen::Vector2d* reference) {
  World world;
  world.settings.step = 1.0 / rate;
  world.settings.integrator = integrator;
  world.settings.energy_return = balance == Balance::returned;
  const BodyId last = hard.make(world);
  double error = -1.0;
  const auto one = static_cast<std::uint64_t>(rate);
  const Watched course = watch(world, 5.0, [&] {
    if (reference && world.steps == one) error = norm(world.motion_of(last).x - vec(reference->x(), reference->y(), 0));
    if (balance != Balance::plain) return;
    for (const auto& articulate : world.articulates) articulate->symmetric_h = 0.0;
  });
  return {course.gap, course.energy_error(), error, world.stats.halved_steps, world.stats.fallback_steps};
}

void run_case(const HardCase& hard) {
  Eigen::Vector2d position;
  if (hard.at_one) position = hard.at_one();
  for (const Integrator integrator : {Integrator::verlet, Integrator::suzuki4, Integrator::adaptive})
    for (const double rate : {60.0, 240.0, 1000.0}) {
      if (integrator == Integrator::adaptive && rate > 60.0) continue;  // it chooses its steps
      const auto with = [&](Balance balance) {
        return outcome(hard, integrator, rate, balance, hard.at_one ? &position : nullptr);
      };
      const Outcome carried = with(Balance::carried);
      std::printf("%-16s %-8s 1/%-5g %9.1e %9.1e %9.1e %9.1e ", hard.name.c_str(),
                  std::string(name_of(integrator)).c_str(), rate, carried.gap, with(Balance::plain).energy,
                  carried.energy, with(Balance::returned).energy);
      if (carried.error < 0.0)
        std::printf("%9s", "-");
      else
        std::printf("%9.2e", carried.error);
      std::printf(" %7llu %5llu\n", static_cast<unsigned long long>(carried.halved),
                  static_cast<unsigned long long>(carried.safe));
    }
}

void run(const player::BenchOptions&) {
  std::printf(
      "5 s from horizontal. energy: largest change relative to the largest kinetic energy, with the plain projection "
      "of\n"
      "velocities, with half of it carried to before the step, and with that and the energy return. The rest is of "
      "the\n"
      "carried half: error is that of the last body's centre at 1 s, from minimal coordinates to round-off\n");
  std::printf("%-16s %-8s %7s %9s %9s %9s %9s %9s %7s %5s\n", "case", "", "step", "gap, m", "plain", "carried",
              "return", "error, m", "halved", "safe");
  for (const HardCase& hard : hard_cases()) run_case(hard);
}

const player::Register registered({"accuracy", "gaps, energy and error of chains, heavy chains and a ring", run});

}  // namespace
