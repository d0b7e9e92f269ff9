#include "choreography/conditions.hpp"

#include <catch2/catch.hpp>

#include "choreography/choreography.hpp"

using namespace pantin;

TEST_CASE("a condition fires once, or at each rise, and only after it fell back by the hysteresis") {
  World world;
  double value = 0.0;
  int once = 0, rises = 0, wide = 0;
  const auto add = [&](bool again, double hysteresis, int& count) {
    Event e;
    e.kind = EventKind::when;
    e.condition.measure = [&value] { return value; };
    e.condition.limit = 1.0;
    e.condition.again = again;
    e.condition.hysteresis = hysteresis;
    e.action = [&count] { count++; };
    add_event(world, e);
  };
  add(false, 0.0, once);
  add(true, 0.0, rises);
  add(true, 0.5, wide);
  double time = 0.0;
  for (const double v : {0.0, 2.0, 2.0, 0.8, 2.0, 0.4, 2.0, std::nan(""), 2.0}) {
    value = v;
    fire_due(world, time += 1.0);
  }
  CHECK(once == 1);
  CHECK(rises == 4);
  CHECK(wide == 3);
}

TEST_CASE("a condition on a mean waits until there is one, and is not fooled by a spike") {
  World world;
  double value = 0.0;
  std::vector<double> fired;
  Event e;
  e.kind = EventKind::when;
  e.condition.measure = [&value] { return value; };
  e.condition.limit = 1.0;
  e.condition.mean = 1.0;
  e.action = [&] { fired.push_back(world.time); };
  add_event(world, e);
  for (int step = 0; step < 60; step++) {
    world.time = 0.1 * step;
    value = step == 15 ? 5.0 : step >= 30 ? 2.0 : 0.0;  // 0.5 in the mean; from 3 s on a ramp of the mean up to 2
    fire_due(world, 0.1 * (step + 1));
  }
  REQUIRE(fired.size() == 1);
  CHECK(fired[0] == Approx(3.5));  // the trapezoids from 2.5 s on: 0.05 · 2 + 0.5 · 2 > 1
}
