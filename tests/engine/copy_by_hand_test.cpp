#include "choreography/copy_by_hand.hpp"

#include <catch2/catch.hpp>

#include "choreography/commands.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"

using namespace pantin;
using Kind = Command::Kind;

namespace {

struct Workshop {
  World world;

  void send(const Command& command) { carry_out(world, std::vector{command}); }
  BodyId last() const { return world.bodies.ids().back(); }
  BodyId make(MadeForm form, Vec3 at, Vec3 amount, BodyId on = {}) {
    Command c;
    c.kind = Kind::make;
    c.form = form;
    c.position = at;
    c.points = {zero3()};
    c.amount = amount;
    c.radius = 0.3;
    if (on) c.thing = on;
    send(c);
    return last();
  }
  /// A box on a wheel with a motor, which a rope holds, a spring ties to a place, and a nail holds.
  BodyId cart() {
    const BodyId box = make(MadeForm::box, vec(1, 2, 0), vec(1, 0.5, 0.5));
    const BodyId wheel = make(MadeForm::wheel, vec(1.5, 1.8, 0), vec(0, 0, 0.6), box);
    Command motor;
    motor.kind = Kind::drive;
    motor.thing = wheel;
    motor.amount = vec(0, 0, 4);
    send(motor);
    tie("rope", box, vec(0.5, 4, 0));
    tie("spring", box, vec(1.5, 4, 0));
    return box;
  }
  void tie(const std::string& name, BodyId body, Vec3 to) {
    Command c;
    c.kind = Kind::tie;
    c.name = name;
    c.thing = body;
    c.position = world.motion_of(body).x;
    c.points = {to};
    send(c);
  }
  void copy(BodyId body, Vec3 to, Vec3 mirror = zero3()) {
    Command c;
    c.kind = Kind::make;
    c.name = "copy";
    c.thing = body;
    c.position = to;
    c.amount = mirror;
    send(c);
  }
};

}  // namespace

TEST_CASE("copy by hand: a machine is copied with all that is joined to it, and goes as it does") {
  Workshop shop;
  const BodyId box = shop.cart();
  shop.copy(box, vec(21, 2, 0));
  REQUIRE(shop.world.log.empty());
  World& world = shop.world;
  CHECK(world.bodies.size() == 4);
  CHECK(hinges(world).size() == 2);
  CHECK(world.connections.size() == 2);
  CHECK(world.constraints.size() == 6);  // motors, ropes, axes of the wheels
  for (int i = 0; i < 240; i++) step(world);
  const std::vector<BodyId> bodies = world.bodies.ids();
  for (std::size_t i = 0; i < 2; i++) {
    const Motion &one = world.motion_of(bodies[i]), &other = world.motion_of(bodies[i + 2]);
    CHECK(norm(other.x - one.x - vec(20, 0, 0)) < 1e-8);
    CHECK(norm(other.p - one.p) < 1e-6 * one.mass);
    CHECK(norm(angular_velocity(other) - angular_velocity(one)) < 1e-6);
  }
}

TEST_CASE("copy by hand: the mirror image moves as a mirror image, motors and all") {
  Workshop shop;
  const BodyId box = shop.cart();
  shop.copy(box, vec(21, 2, 0), vec(1, 0, 0));
  World& world = shop.world;
  REQUIRE(world.log.empty());
  for (int i = 0; i < 240; i++) step(world);
  const std::vector<BodyId> bodies = world.bodies.ids();
  for (std::size_t i = 0; i < 2; i++) {
    const Motion &one = world.motion_of(bodies[i]), &other = world.motion_of(bodies[i + 2]);
    CHECK(norm(other.x - vec(22.0 - one.x[0], one.x[1], one.x[2])) < 1e-8);
    CHECK(norm(angular_velocity(other) + angular_velocity(one)) < 1e-6);
  }
}

TEST_CASE("copy by hand: what is gone cannot be copied, and what cannot be copied leaves nothing behind") {
  Workshop shop;
  const BodyId box = shop.cart();
  Command gone;
  gone.kind = Kind::remove;
  gone.name = "whole";
  gone.thing = box;
  Workshop other;
  other.cart();
  const BodyId first = other.world.bodies.ids().front();
  gone.thing = first;
  other.send(gone);
  CHECK(other.world.bodies.empty());
  CHECK(other.world.constraints.empty());
  other.copy(first, vec(9, 9, 0));
  REQUIRE(other.world.log.size() == 1);
  CHECK_THAT(other.world.log[0].text, Catch::Contains("removed"));
  add_nail(shop.world, shop.world.bodies[box].points[0]);
  FollowDef follow;
  follow.at = vec(1, 1, 0);
  follow.max_force = 1.0;
  add_follow(shop.world, shop.world.bodies[shop.last()].points[0], follow);
  const std::size_t points = shop.world.points.size(), constraints = shop.world.constraints.size();
  shop.copy(box, vec(21, 2, 0));
  CHECK(shop.world.bodies.size() == 2);
  CHECK(shop.world.points.size() == points);
  CHECK(shop.world.constraints.size() == constraints);
  REQUIRE(shop.world.log.size() == 1);
  CHECK_THAT(shop.world.log[0].text, Catch::Contains("cannot be copied"));
}
