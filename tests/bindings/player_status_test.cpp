#include <catch2/catch.hpp>

#include "player/status.hpp"

using namespace pantin;
using namespace pantin::player;
using Catch::Contains;
using Catch::VectorContains;

namespace {

std::vector<std::string> parts_of(const Status& status, const World& world, const Pacing& pacing, double pace,
                                  bool paused, bool solver = false) {
  std::vector<std::string> parts;
  status.write(world, pacing, {pace, paused, solver}, parts);
  return parts;
}

}  // namespace

TEST_CASE("status: time with three digits and speed; errors on demand") {
  World world;
  world.time = 3.456;
  world.error.energy = 1.25e-12;
  world.error.constraint = 3e-15;
  Status status;
  Pacing pacing;
  std::vector<std::string> parts = parts_of(status, world, pacing, 0.5, false);
  CHECK_THAT(parts, VectorContains(std::string("3.46 s")));
  CHECK_THAT(parts, VectorContains(std::string("speed 0.5×")));
  CHECK(parts.size() == 2);
  parts = parts_of(status, world, pacing, 0.5, false, true);
  CHECK_THAT(parts, VectorContains(std::string("energy error 1.2e-12")) ||
                        VectorContains(std::string("energy error 1.3e-12")));
  CHECK_THAT(parts, VectorContains(std::string("largest gap 3.0e-15 m")));
  CHECK_THAT(parts_of(status, world, pacing, 1.0, true), VectorContains(std::string("paused")));
  for (const auto& [time, told] : {std::pair(12.34, "12.3 s"), {1234.5, "1234 s"}, {3.21e-6, "3.21e-06 s"}}) {
    world.time = time;
    CHECK(parts_of(status, world, pacing, 1.0, false)[0] == told);
  }
}

TEST_CASE("status: slow motion says how slow, at the scene's pace") {
  World world;
  Pacing pacing;
  for (int i = 0; i < 200; i++) {
    pacing.begin_frame(0.1, 0.01, 2.0);
    pacing.end_frame(5, 0.09);
  }
  CHECK_THAT(parts_of(Status(), world, pacing, 2.0, false), VectorContains(std::string("slow motion 0.5×")));
}

TEST_CASE("status: a note is shown") {
  World world;
  Status status;
  status.note("wrote pantin-0001.png");
  CHECK(parts_of(status, world, Pacing(), 1.0, false).back() == "wrote pantin-0001.png");
}
