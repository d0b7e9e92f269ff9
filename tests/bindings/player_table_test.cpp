#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "player/frame_clock.hpp"
#include "player/table.hpp"

using namespace pantin;
using pantin::player::probe_table;
using pantin::player::Times;

TEST_CASE("table: a row per step, numbers that read back as the same doubles") {
  Times times{0, {1.0 / 3.0, 2.0 / 3.0}};
  Probe tip;
  tip.name = "tip height";
  tip.values = {0.1 + 0.2, -1e-300};
  std::string csv = probe_table(times, {tip});
  CHECK(csv == "time,tip height\n0.3333333333333333,0.30000000000000004\n0.6666666666666666,-1e-300\n");
  CHECK(std::strtod("0.30000000000000004", nullptr) == 0.1 + 0.2);
}

TEST_CASE("table: a probe that was added later has empty cells before") {
  Times times{0, {1, 2, 3}};
  Probe early, late;
  early.name = "a";
  early.values = {10, 20, 30};
  late.name = "b";
  late.first_step = 2;
  late.values = {300};
  CHECK(probe_table(times, {early, late}) == "time,a,b\n1,10,\n2,20,\n3,30,300\n");
}

TEST_CASE("table: names with commas and quotes are quoted") {
  Times times{0, {}};
  Probe odd;
  odd.name = "x, \"the\" place";
  CHECK(probe_table(times, {odd}) == "time,\"x, \"\"the\"\" place\"\n");
}

TEST_CASE("table: a row for each so many seconds and for the last step, with what was between") {
  Times times;
  Probe wave;
  wave.name = "x";
  for (int step = 1; step <= 10; step++) {
    times.values.push_back(0.1 * step);
    wave.values.push_back(step);
  }
  CHECK(probe_table(times, {wave}, {.every = 0.4}) == "time,x\n0.4,4\n0.8,8\n1,10\n");
  CHECK(probe_table(times, {wave}, {.every = 0.5, .reductions = {"least", "largest", "mean", "rms"}}) ==
        "time,x,x least,x largest,x mean,x rms\n0.5,5,1,5,3,3.3166247903554\n1,10,6,10,8,8.12403840463596\n");
  CHECK(probe_table(times, {wave}, {.every = 1e-9}) == probe_table(times, {wave}));
  wave.first_step = 5;
  CHECK(probe_table({0, {0.1, 0.2}}, {wave}, {.every = 0.2, .reductions = {"mean"}}) == "time,x,x mean\n0.2,,\n");
}

TEST_CASE("table: a row where a probe changes, with what was between") {
  Times times;
  Probe touches, wave;
  touches.name = "touches";
  wave.name = "x";
  touches.first_step = 1;
  for (int step = 1; step <= 10; step++) {
    times.values.push_back(0.1 * step);
    wave.values.push_back(step);
    if (step > 1) touches.values.push_back(step < 4 ? 0 : step < 8 ? 1 : 2);
  }
  CHECK(probe_table(times, {touches, wave}, {.when = {"touches"}}) ==
        "time,touches,x\n0.2,0,2\n0.4,1,4\n0.8,2,8\n1,2,10\n");
  CHECK(probe_table(times, {touches}, {.every = 0.5, .when = {"touches"}}) ==
        "time,touches\n0.2,0\n0.4,1\n0.5,1\n0.8,2\n1,2\n");
  CHECK(probe_table(times, {touches, wave}, {.when = {"touches"}, .reductions = {"mean"}}) ==
        "time,touches,touches mean,x,x mean\n0.2,0,0,2,1.5\n0.4,1,0.5,4,3.5\n0.8,2,1.25,8,6.5\n1,2,2,10,9.5\n");
  CHECK(probe_table(times, {wave}, {.when = {"x"}}) == probe_table(times, {wave}));
}

TEST_CASE("table: without probes, the times") { CHECK(probe_table(Times{0, {0.5}}, {}) == "time\n0.5\n"); }

TEST_CASE("table: rows are dropped where the world went back, and are there again where it went forward") {
  World world;
  world.settings.step = 0.5;
  Times times;
  const auto be_at = [&](std::uint64_t steps) {
    world.steps = steps;
    world.time = 0.5 * static_cast<double>(steps);
    times.add(world);
  };
  for (std::uint64_t step = 1; step <= 4; step++) be_at(step);
  CHECK(times.values == SharedList{0.5, 1.0, 1.5, 2.0});
  be_at(2);
  CHECK(times.values == SharedList{0.5, 1.0});
  be_at(3);
  CHECK(times.values == SharedList{0.5, 1.0, 1.5});
  be_at(0);
  CHECK(times.values.empty());
  be_at(1);
  be_at(3);
  CHECK(times.first_step == 0);
  CHECK(times.values == SharedList{0.5, 1.0, 1.5});
}

TEST_CASE("frame clock: frames go on where the world goes back") {
  World world;
  world.settings.step = 0.5;
  player::FrameClock clock{2.0};
  std::vector<int> taken;
  for (const std::uint64_t step : std::vector<std::uint64_t>{0, 1, 2, 3, 1, 2, 3, 9, 10}) {
    world.steps = step;
    world.time = 0.5 * static_cast<double>(step);
    int count = 0;
    while (clock.take(world)) count++;
    taken.push_back(count);
  }
  CHECK(taken == std::vector<int>{1, 1, 1, 1, 0, 1, 1, 0, 1});
}
