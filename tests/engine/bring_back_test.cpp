#include "choreography/bring_back.hpp"

#include <catch2/catch.hpp>

#include "choreography/commands.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "measure/query.hpp"

using namespace pantin;

namespace {

BodyId rod_at(World& world, Vec3 at) {
  BodyDef def;
  def.at = at;
  def.mass = 1.0;
  def.inertia = identity33() * 0.1;
  def.points.resize(2);
  def.points[0].at = vec(-0.5, 0, 0);
  def.points[1].at = vec(0.5, 0, 0);
  return add_body(world, def);
}

/// Two rods on a hinge.
BodyId pair_at(World& world, Vec3 at) {
  const BodyId a = rod_at(world, at), b = rod_at(world, at + vec(1, 0, 0));
  const std::array ends = {world.bodies[a].points[1], world.bodies[b].points[0]};
  add_hinge(world, ends);
  return a;
}

}  // namespace

TEST_CASE("bring back: what fell out is each thing with what is joined to it, that nothing ties to the world") {
  World world;
  rod_at(world, zero3());
  pair_at(world, vec(0, -100, 0));
  const BodyId nailed = rod_at(world, vec(50, 0, 0));
  add_nail(world, world.bodies[nailed].points[0]);

  const std::vector<Things> out = fallen_out(world, zero3(), 10.0, 100);
  REQUIRE(out.size() == 1);
  CHECK(out[0].bodies.size() == 2);
  CHECK(fallen_out(world, zero3(), 1000.0, 100).empty());
  CHECK(fallen_out(world, zero3(), 10.0, 0).empty());
}

TEST_CASE("bring back: it keeps its shape, is at rest, and its middle is where it was put") {
  World world;
  const BodyId a = pair_at(world, vec(3, -100, 2));
  set_velocity(world, a, vec(0, -40, 0));
  const Vec3 between = origin(world, a) - position(world, world.bodies[a].points[0]);

  Command command;
  command.kind = Command::Kind::bring;
  command.thing = a;
  command.position = vec(0, 5, 0);
  carry_out(world, std::span(&command, 1));

  const Bounds box = bounds(world, everything(world));
  CHECK(norm(0.5 * (box.low + box.high) - vec(0, 5, 0)) < 1e-12);
  CHECK(norm(origin(world, a) - position(world, world.bodies[a].points[0]) - between) < 1e-12);
  CHECK(norm(momentum(world, everything(world))) == 0.0);

  command.position = vec(0, infinity, 0);
  carry_out(world, std::span(&command, 1));
  CHECK(world.log.back().text.find("bring by hand 1: ") == 0);
}
