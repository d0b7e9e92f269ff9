#include "choreography/copy_by_hand.hpp"

#include <catch2/catch.hpp>

#include "choreography/commands.hpp"
#include "edit/assemble.hpp"
#include "edit/coupling_constraints.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "model/cover.hpp"
#include "shapes/hull.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

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

/// A chain that every kind of constraint ties, but for what is on a path. Returns its first link.
BodyId add_all_kinds(World& world) {
  std::vector<BodyId> links;
  for (int i = 0; i < 9; i++) {
    BodyDef def;
    def.at = vec(i + 0.5, 0.1 * i, 0);
    def.spin = vec(0.1 * i, 0.2, -0.1);
    links.push_back(cases::add_rod_body(world, 1.0 + i, 1.0, def));
  }
  const auto head = [&](std::size_t i) { return world.bodies[links[i]].points[0]; };
  const auto tail = [&](std::size_t i) { return world.bodies[links[i]].points[1]; };
  const auto loose = [&](Vec3 at) {
    ParticleDef def;
    def.at = at;
    return cases::point_of(world, add_particle(world, def));
  };
  add_nail(world, head(0));
  add_string(world, {{tail(0)}, {{}, vec(1, 2, 1)}, {head(1)}}, {});
  HingeDef axis;
  axis.axis = vec(0, 0.2, 1);
  set_position(world, links[2], world.motion_of(links[2]).x + position(world, tail(1)) - position(world, head(2)));
  const PointId joint[] = {tail(1), head(2)};
  add_hinge(world, joint, axis);
  MotorDef motor;
  motor.axis = axis.axis.value();
  motor.angle = 0.3;
  add_motor(world, links[2], links[1], motor);
  add_weld(world, links[2], links[3]);
  add_limit(world, links[4], links[3], vec(0, 1, 1), {-0.2, 0.1, 0.1});
  add_rod(world, tail(3), head(4));
  add_align(world, links[5], links[4], {vec(1, 0, 0), vec(0, 1, 0.1), {}, 0.1});
  add_limit(world, head(5), tail(4), {0.05, 0.2, 0.1});
  GearDef gear;
  gear.axis_a = vec(1, 0, 0);
  gear.axis_b = vec(1, 1, 0);
  gear.ratio.value = 2.0;
  add_gear(world, links[6], links[5], gear);
  RackDef rack;
  rack.axis = vec(0, 0, 1);
  rack.along = vec(1, 0, 1);
  rack.radius.value = 0.5;
  add_rack(world, links[6], tail(5), rack);
  add_pulley(world, head(6), {{}, vec(6, 3, 1)}, head(7), {{}, vec(7, 3, -1)}, {});
  add_screw(world, tail(6), head(7), {.axis = vec(1, 0, 0), .lead = {0.1, {}}});
  SliderDef slider;
  slider.axis = vec(1, 2, 0);
  slider.carrier = links[6];
  slider.turns = true;
  add_slider(world, head(8), slider);
  add_orient(world, links[8], {Quat{0.8, 0.6, 0, 0}, {}});
  JoinDef join;
  join.max_force = 20.0;
  add_join(world, tail(7), head(8), join);
  add_rod(world, tail(8), vec(9, 3, 0.5));
  const PointId stone = loose(vec(9, 4, 1));
  add_rod(world, tail(7), stone);
  cases::add_on_plane(world, stone, vec(0, 1, 1));
  FollowDef follow;
  follow.at = vec(4, 3, 0);
  follow.max_force = 3.0;
  add_follow(world, head(3), follow);
  return links[0];
}

}  // namespace

TEST_CASE("copy by hand: every kind of constraint holds in the mirror image as it does in what was copied") {
  for (const Vec3 mirror : {zero3(), vec(1, 0, 0), vec(1, 0, -1)}) {  // gravity lies in it
    INFO(mirror[0] << " " << mirror[1]);
    Workshop shop;
    World& world = shop.world;
    const BodyId first = add_all_kinds(world);
    const std::size_t constraints = world.constraints.size();
    const Vec3 from = world.motion_of(first).x, to = from + vec(30, 0, 0);
    shop.copy(first, to, mirror);
    INFO((world.log.empty() ? "" : world.log[0].text));
    REQUIRE(world.constraints.size() == 2 * constraints);
    for (int i = 0; i < 120; i++) step(world);
    REQUIRE(world.failure.empty());
    const std::vector<BodyId> bodies = world.bodies.ids();
    const std::size_t copied = bodies.size() / 2;
    for (std::size_t i = 0; i < copied; i++) {
      const Motion &one = world.motion_of(bodies[i]), &other = world.motion_of(bodies[i + copied]);
      Vec3 way = one.x - from;
      if (norm2(mirror) > 0.0) way = way - mirror * (2.0 * dot(way, mirror) / norm2(mirror));
      INFO("body " << i);
      CHECK(norm(other.x - to - way) < 1e-6);
      CHECK(norm(one.x - from) > 1e-4);
    }
  }
}

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
  follow.target = [](double t) { return vec(1, 1 + t, 0); };
  follow.max_force = 1.0;
  add_follow(shop.world, shop.world.bodies[shop.last()].points[0], follow);
  const std::size_t points = shop.world.points.size(), constraints = shop.world.constraints.size();
  shop.copy(box, vec(21, 2, 0));
  CHECK(shop.world.bodies.size() == 2);
  CHECK(shop.world.points.size() == points);
  CHECK(shop.world.constraints.size() == constraints);
  REQUIRE(shop.world.log.size() == 1);
  CHECK_THAT(shop.world.log[0].text, Catch::Contains("follow"));
  CHECK_THAT(shop.world.log[0].text, Catch::Contains("is led by a function"));
}

TEST_CASE("copy by hand: a copy has picture and sprite, and in the mirror image the picture's box is mirrored") {
  Workshop shop;
  BodyDef def;
  def.shapes.emplace_back().geometry = make_hull(std::vector{vec(0, 0, 0), vec(1, 0, 0), vec(0, 2, 0), vec(0, 0, 1)});
  def.shapes[0].cover = std::make_shared<const Cover>(Cover{{}, 0.5, vec(0, 0, 0), vec(1, 2, 1)});
  def.sprite = def.shapes[0].cover;
  shop.copy(add_body(shop.world, def), vec(4, 0, 0), vec(1, 0, 0));
  const Body& made = shop.world.bodies[shop.last()];
  const Cover& cover = *shop.world.shapes[made.shapes[0]].cover;
  CHECK(same(cover.low, vec(-1, 0, 0)));
  CHECK(same(cover.high, vec(0, 2, 1)));
  CHECK(cover.width == 0.5);
  CHECK(made.sprite == def.sprite);
}
