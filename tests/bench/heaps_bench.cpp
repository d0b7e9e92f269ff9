// `pantin bench heaps [CASE…]`: piles of many seeds that fall into a bin and come to rest, at two rates: what they gain, what
// goes through, when they sleep.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/check.hpp"
#include "edit/edit.hpp"
#include "forces/sleep.hpp"
#include "measure/measure.hpp"
#include "peers/pile_trial.hpp"
#include "peers/piles.hpp"
#include "player/bench.hpp"
#include "player/machine.hpp"
#include "step/step.hpp"
#include "support/mechanisms.hpp"

using namespace pantin;

namespace {

constexpr double moves = 3.0;  // [s] "in motion": from the start until then

struct Fall {
  double step = 0.0;               ///< [ns] of the processor, in motion, per step
  double subs = 0.0;               ///< sub-steps, in motion, per step
  double contacts = 0.0;           ///< in motion, per step
  double rise = 0.0, rises = 0.0;  ///< of the start's energy: the largest of a step, and all; less what opens overlaps
  double pushed = 0.0;             ///< of the start's energy: what opened overlaps
  double deepest = 0.0;            ///< [m] overlap, of each eighth step
  double outside = 0.0;            ///< [m] centres behind a wall
  double gap = 0.0;                ///< [m] of a hinge
  double asleep = std::numeric_limits<double>::infinity();  ///< [s] when all slept
  std::uint64_t unsolved = 0;
};

/// [J] Kinetic, and potential above the floor.
double energy_of(const World& world) {
  const Energy e = energy(world);
  return e.kinetic + e.potential;
}

double behind_walls(const World& world, const std::vector<BodyId>& bodies, const peers::Mechanism& pile) {
  double most = 0.0;
  for (const BodyId body : bodies) {
    const Vec3 x = world.motion_of(body).x;
    for (const peers::Wall& wall : pile.walls)
      most = std::max(most, wall.offset - (wall.normal.x() * x[0] + wall.normal.y() * x[1] + wall.normal.z() * x[2]));
  }
  return most;
}

Fall fall(const peers::Mechanism& pile, double rate, double until, double lever) {
  World world;
  world.settings.step = 1.0 / rate;
  world.settings.gravity = vec(0, -peers::gravity, 0);
  keep_ledger(world);
  const std::vector<BodyId> bodies = support::add_mechanism(world, pile);
  for (const ShapeId shape : world.shapes.ids()) {
    set_rolling(world, shape, lever);
    set_spinning(world, shape, lever);
  }
  Fall f;
  std::vector<peers::SolidState> state;
  const double start = energy_of(world);
  double last = start;
  const long steps = std::lround(until * rate), moving = std::lround(std::min(until, moves) * rate);
  for (long i = 1; i <= steps; i++) {
    const double began = player::thread_time();
    step(world);
    if (i <= moving) f.step += (player::thread_time() - began) / static_cast<double>(moving);
    require(world.failure.empty(), world.failure);
    if (i <= moving) f.subs += static_cast<double>(world.sub_steps.count) / static_cast<double>(moving);
    if (i <= moving) f.contacts += static_cast<double>(world.contacts.list.size()) / static_cast<double>(moving);
    f.pushed = world.ledger.given[static_cast<std::size_t>(Source::push_out)];
    const double now = energy_of(world) - f.pushed, gain = std::max(0.0, now - last) / start;
    last = now;
    f.rise = std::max(f.rise, gain);
    f.rises += gain;
    support::read_solids(world, bodies, state);
    f.gap = std::max(f.gap, peers::largest_separation(pile, state));
    if (i % 8 == 0) f.deepest = std::max(f.deepest, peers::deepest_overlap(pile, state));
    f.outside = std::max(f.outside, behind_walls(world, bodies, pile));
    if (world.contacts.sleepers.size() < bodies.size()) continue;
    f.asleep = world.time;
    break;
  }
  f.pushed /= start;
  f.unsolved = world.stats.unsolved_islands;
  return f;
}

void print(const std::string& pile, std::uint32_t seed, double rate, const Fall& f) {
  std::printf("%-12s %4u %4.0f %8.1f %5.2f %6.0f %6.0f %9.1e %9.1e %9.1e %8.1e %8.1e %8.1e %8llu %7.2f\n", pile.c_str(),
              seed, rate, f.step / 1e3, f.subs, f.contacts, f.step / f.contacts, f.rise, f.rises, f.pushed, f.deepest,
              f.outside, f.gap, static_cast<unsigned long long>(f.unsolved), f.asleep);
  std::fflush(stdout);
}

void bench_heaps(const player::BenchOptions& options) {
  std::vector<std::string> piles = {"boxes(100)", "balls(100)", "slabs(80)", "mixed(100)", "chains(12)", "heavy(80)"};
  std::uint32_t seeds = 5;
  double until = 15.0, lever = 0.0;
  std::vector<double> rates = {60.0, 240.0};
  std::vector<std::string> named;
  for (const std::string& argument : options.arguments) {
    if (argument.starts_with("seeds="))
      seeds = static_cast<std::uint32_t>(std::stoul(argument.substr(6)));
    else if (argument.starts_with("until="))
      until = std::stod(argument.substr(6));
    else if (argument.starts_with("rolling="))
      lever = std::stod(argument.substr(8));
    else if (argument.starts_with("rate="))
      rates = {std::stod(argument.substr(5))};
    else
      named.push_back(argument);
  }
  if (!named.empty()) piles = named;
  std::printf(
      "Friction %g. In motion: until %g s. rise: the largest of the energy in a step, rises: all of them, beyond what "
      "opens\n"
      "overlaps, and pushed: that, over the energy of the start. deep: overlap. out: centres behind walls. gap: of "
      "hinges.\n",
      peers::friction, moves);
  std::printf("%-12s %4s %4s %8s %5s %6s %6s %9s %9s %9s %8s %8s %8s %8s %7s\n", "", "seed", "Hz", "us/step", "subs",
              "points", "ns", "rise", "rises", "pushed", "deep, m", "out, m", "gap, m", "unsolved", "asleep");
  for (const std::string& name : piles)
    for (const double rate : rates)
      for (std::uint32_t seed = 1; seed <= seeds; seed++)
        print(name, seed, rate, fall(peers::pile(name, false, seed), rate, until, lever));
}

const player::Register registered(
    {"heaps",
     "what falls into a bin, of five seeds at 60 and 240 Hz: gains, overlaps, sleep; arguments: cases, as boxes(100), "
     "seeds=1, until=3, rate=240",
     bench_heaps});

}  // namespace
