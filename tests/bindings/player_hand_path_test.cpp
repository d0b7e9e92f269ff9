#include <catch2/catch.hpp>

#include "choreography/hands.hpp"
#include "edit/edit.hpp"
#include "player/hand_path.hpp"

using namespace pantin;
using namespace pantin::player;

TEST_CASE("hand path: a hand that holds something moves evenly over the steps of a frame") {
  World world;
  PointId point = world.particles[add_particle(world, {})].points.front();
  std::int32_t hand = add_hand(world);
  world.hands[0].position = vec(1, 0, 0);
  world.hands[0].placed = true;
  grab(world, hand, point);

  StepInput frame;
  frame.moves.push_back({hand, vec(5, 2, 0), true});
  frame.commands.push_back({});
  HandPath path(world, frame, 4);
  CHECK(path.input(0).commands.size() == 1);
  CHECK(path.input(1).commands.empty());
  CHECK(path.input(0).moves.at(0).position[0] == 2.0);
  CHECK(path.input(1).moves.at(0).position[1] == 1.0);
  CHECK(path.input(3).moves.at(0).position[0] == 5.0);
  CHECK(path.input(3).moves.at(0).pressed);
}

TEST_CASE("hand path: a hand that holds nothing is there at once") {
  World world;
  std::int32_t hand = add_hand(world);
  world.hands[0].placed = true;
  StepInput frame;
  frame.moves.push_back({hand, vec(5, 2, 0), false});
  HandPath path(world, frame, 2);
  CHECK(path.input(0).moves.at(0).position[0] == 5.0);
}

TEST_CASE("hand path: of the moves that wait, the last of each hand stays") {
  StepInput input;
  input.moves = {{0, vec(1, 0, 0), false}, {1, vec(2, 0, 0), true}, {0, vec(3, 0, 0), true}};
  keep_last_moves(input);
  REQUIRE(input.moves.size() == 2);
  CHECK(input.moves[0].position[0] == 3.0);
  CHECK(input.moves[0].pressed);
  CHECK(input.moves[1].position[0] == 2.0);
}
