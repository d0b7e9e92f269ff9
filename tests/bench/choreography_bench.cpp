// `pantin bench choreography`: what waiting events cost a step, and one merge and one cut among many bodies.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/clock.hpp"
#include "choreography/choreography.hpp"
#include "edit/assemble.hpp"
#include "laws/library.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr int waiting = 100'000, calls = 1000, windows = 10;

/// [s] of one call of fire_due with so many events waiting for later.
double waiting_cost(int events) {
  World world;
  for (int i = 0; i < events; i++) {
    Event event;
    event.time = 1e6 + i;
    event.action = [] {};
    add_event(world, std::move(event));
  }
  double best = std::numeric_limits<double>::infinity();
  for (int w = 0; w < windows; w++) {
    const double start = now();
    for (int k = 0; k < calls; k++) fire_due(world, 1e-6 * k);
    best = std::min(best, (now() - start) / calls);
  }
  return best;
}

/// [s] of firing one of so many events.
double firing_cost(int events) {
  World world;
  for (int i = 0; i < events; i++) {
    Event event;
    event.time = 1e-3 * (events - i);
    event.action = [] {};
    add_event(world, std::move(event));
  }
  const double start = now();
  fire_due(world, 1e-3 * (events + 1));
  return (now() - start) / events;
}

enum class Acting { nothing, pairs, springs, drag };

struct EditCost {
  double step = 1e9, after_merge = 1e9, after_cut = 1e9, after_kick = 1e9;  // [s] with the edit before the step
};

std::shared_ptr<const Law> law_of(std::string_view name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  return std::make_shared<const Law>(make_library_law(name, arguments).front());
}

/// Has a law act on all ends of the links, or on those of neighbours in neighbouring chains.
void add_law(World& world, const std::vector<cases::Chain>& chains, Acting acting) {
  if (acting == Acting::pairs) {
    FamilyDef def;
    def.name = "ends";
    const FamilyId ends = add_family(world, def);
    for (ParticleId id : world.particles.ids())
      if (!world.particles[id].asleep_in) set_family(world, id, ends);
    add_interaction(world, law_of("wca", {{"epsilon", 0.01}, {"sigma", 1.2}}), ends, ends);
  }
  const auto spring = law_of("spring", {{"stiffness", 0.1}, {"length", 1.0}});
  if (acting == Acting::springs)
    for (std::size_t i = 1; i < chains.size(); i++)
      for (std::size_t k = 0; k < chains[i].tails.size(); k++) {
        ConnectionDef ends;
        ends.ends = {End{world.points[chains[i - 1].tails[k]].particle},
                     End{world.points[chains[i].tails[k]].particle}};
        add_connection(world, spring, ends);
      }
  if (acting == Acting::drag) add_field(world, law_of("drag", {{"linear", 0.1}}), {});
}

EditCost edit_cost(Acting acting) {
  constexpr int chains = 1000, links = 10;
  World world;
  std::vector<cases::Chain> all;
  for (int i = 0; i < chains; i++) all.push_back(cases::add_chain(world, {.links = links, .start = vec(0, 0, i)}));
  add_law(world, all, acting);
  for (int i = 0; i < 20; i++) step(world);
  EditCost cost;
  const auto timed = [&](double& best, auto edit) {
    const double start = now();
    edit();
    step(world);
    best = std::min(best, now() - start);
  };
  for (std::size_t i = 0; i < 12; i++) {
    timed(cost.step, [] {});
    timed(cost.after_merge, [&] { merge(world, all[i].bodies[4], all[i].bodies[5]); });
    timed(cost.after_cut, [&] { cut(world, all[100 + i].hinges[4]); });
    timed(cost.after_kick, [&] { kick(world, all[200 + i].bodies[4], vec(0, 0, 0.1)); });
  }
  return cost;
}

void bench_choreography(const player::BenchOptions&) {
  std::printf("%-44s %10.3f us\n", "a step with no events", 1e6 * waiting_cost(0));
  std::printf("%-44s %10.3f us\n", "a step with 100000 events that wait", 1e6 * waiting_cost(waiting));
  std::printf("%-44s %10.3f us\n", "one event of 100000 that fire", 1e6 * firing_cost(waiting));
  std::printf("\n1000 chains of 10 links, ms\n%-24s %10s %16s %16s %16s\n", "law", "a step", "more by a merge",
              "by a cut", "by a kick");
  constexpr const char* names[] = {"none", "pairs of ends", "springs", "drag"};
  for (Acting acting : {Acting::nothing, Acting::pairs, Acting::springs, Acting::drag}) {
    const EditCost cost = edit_cost(acting);
    std::printf("%-24s %10.3f %16.3f %16.3f %16.3f\n", names[static_cast<int>(acting)], 1e3 * cost.step,
                1e3 * (cost.after_merge - cost.step), 1e3 * (cost.after_cut - cost.step),
                1e3 * (cost.after_kick - cost.step));
    std::fflush(stdout);
  }
}

const player::Register choreography_benchmark({"choreography",
                                               "events that wait and fire; edits among 10,000 bodies and laws",
                                               bench_choreography});

}  // namespace
