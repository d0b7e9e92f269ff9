// What falls into a bin, of every kind, from its fall to its sleep. `pantin bench heaps` has more seeds and two rates of each.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iterator>

#include "measure/measure.hpp"
#include "peers/pile_trial.hpp"
#include "peers/piles.hpp"
#include "step/step.hpp"
#include "support/mechanisms.hpp"

using namespace pantin;

namespace {

struct Heap {
  peers::Mechanism pile;
  World world;
  std::vector<BodyId> bodies;
  std::vector<peers::SolidState> state;

  explicit Heap(const std::string& name, std::uint32_t seed = 1) : pile(peers::pile(name, false, seed)) {
    world.settings.gravity = vec(0, -peers::gravity, 0);
    keep_ledger(world);
    bodies = support::add_mechanism(world, pile);
  }
  void step() {
    pantin::step(world);
    support::read_solids(world, bodies, state);
  }
  double less_push_out() const {
    const Energy e = energy(world);
    return e.kinetic + e.potential - world.ledger.given[static_cast<std::size_t>(Source::push_out)];
  }
  bool within_walls() const {
    for (const peers::SolidState& s : state)
      for (const peers::Wall& wall : pile.walls)
        if (wall.normal.dot(s.position) < wall.offset) return false;
    return true;
  }
};

}  // namespace

TEST_CASE("Heaps: hinges of what is pressed and pushed out stay closed, as the ends of each tell") {
  Heap heap(GENERATE("chains(6)", "ragdolls(3)"));
  double gap = 0.0;
  while (heap.world.time < 2.0) {
    heap.step();
    gap = std::fmax(gap, peers::largest_separation(heap.pile, heap.state));
  }
  CHECK(heap.world.ledger.given[static_cast<std::size_t>(Source::push_out)] != 0.0);
  CHECK(gap < 1e-11);
  CHECK(gap <= 2.0 * heap.world.worst.hinge_gap + 1e-14);
}

TEST_CASE("Heaps: what falls into a bin gains nothing, stays in it; boxes, balls and slabs fall asleep", "[slow]") {
  const auto [name, rise_allowed] =
      GENERATE(std::pair("boxes(100)", 1e-5), std::pair("balls(100)", 1e-5), std::pair("slabs(80)", 2e-5),
               std::pair("mixed(60)", 1e-5), std::pair("chains(8)", 1e-5), std::pair("heavy(60)", 1e-3));
  CAPTURE(name);
  Heap heap(name);
  const double start = heap.less_push_out();
  double last = start, rise = 0.0, rises = 0.0;
  while (heap.world.time < 10.0 && heap.world.contacts.sleepers.size() < heap.bodies.size()) {
    heap.step();
    const double now = heap.less_push_out();
    rise = std::fmax(rise, now - last);
    rises += std::fmax(0.0, now - last);
    last = now;
    REQUIRE(heap.within_walls());
  }
  CHECK(rise < rise_allowed * start);
  CHECK(rises < 1e-3 * start);
  const std::string rest[] = {"boxes(100)", "balls(100)", "slabs(80)"};
  const bool rests = std::find(std::begin(rest), std::end(rest), name) != std::end(rest);
  CHECK((!rests || heap.world.contacts.sleepers.size() == heap.bodies.size()));
}

TEST_CASE("Heaps: slabs that fall into a bin gain nothing at 60 Hz", "[slow]") {
  const auto seed = GENERATE(range(std::uint32_t{1}, std::uint32_t{6}));
  CAPTURE(seed);
  Heap heap("slabs(80)", seed);
  heap.world.settings.step = 1.0 / 60.0;
  const double start = heap.less_push_out();
  double last = start, rise = 0.0, rises = 0.0;
  while (heap.world.time < 4.0) {
    heap.step();
    const double now = heap.less_push_out();
    rise = std::fmax(rise, now - last);
    rises += std::fmax(0.0, now - last);
    last = now;
  }
  CHECK(rise < 1e-5 * start);
  CHECK(rises < 1e-4 * start);
}

TEST_CASE("Heaps: bins of boxes come to rest at 60 Hz, and nothing throws about what lies still", "[slow]") {
  const auto seed = GENERATE(std::uint32_t{1}, std::uint32_t{2}, std::uint32_t{3});
  CAPTURE(seed);
  Heap heap("boxes(100)", seed);
  heap.world.settings.step = 1.0 / 60.0;
  const double start = heap.less_push_out();
  double last = start, rises = 0.0;
  // Of eight seeds all were at rest after 3 to 11 s: one box that stands late may fall late.
  while (heap.world.time < 20.0 && heap.world.contacts.sleepers.size() < heap.bodies.size()) {
    heap.step();
    const double now = heap.less_push_out();
    rises += std::fmax(0.0, now - last);
    last = now;
  }
  // One on two points alone may turn about them for ever, and keeps all awake.
  std::size_t moving = 0;
  for (const BodyId body : heap.bodies) {
    const Motion& m = heap.world.motion_of(body);
    if (norm(m.p) / m.mass + 0.3 * norm(angular_velocity(m)) > 1e-6) moving++;
  }
  CHECK(moving <= 1);
  CHECK(rises < 1e-4 * start);
}
