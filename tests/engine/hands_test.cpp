#include "choreography/hands.hpp"
#include "choreography/choreography.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "step/step.hpp"
#include "support/rods.hpp"

using namespace pantin;
using namespace pantin::test;
using Catch::Contains;

namespace {

/// Gives the world a step's input; the time goes on as a step's end does it.
void feed(World& world, StepInput input, double h = 0.1) {
  world.input = std::move(input);
  world.step_origin = world.time;
  world.settings.step = h;
  apply_input(world, world.time + h);
  sample_targets(world);
  CHECK((world.input.moves.empty() && world.input.commands.empty()));
  world.time += h;
}

StepInput move(std::int32_t hand, Vec3 at, bool pressed = false) {
  StepInput input;
  input.moves.push_back({hand, at, pressed});
  return input;
}

StepInput command(Command::Kind kind, std::int32_t hand = 0) {
  StepInput input;
  input.commands.resize(1);
  input.commands[0].kind = kind;
  input.commands[0].hand = hand;
  return input;
}

std::vector<Notice::Kind> kinds(const World& world) {
  std::vector<Notice::Kind> list;
  for (const Notice& n : world.notices) list.push_back(n.kind);
  return list;
}

using Kind = Notice::Kind;

}  // namespace

TEST_CASE("a hand goes where the input says, and has its velocity") {
  World world;
  feed(world, move(1, vec(1, 0, 0)));
  REQUIRE(world.hands.size() == 2);
  CHECK_FALSE(world.hands[0].placed);
  CHECK(same(world.hands[1].velocity, zero3()));
  feed(world, move(1, vec(2, 0, 0)));
  CHECK(norm(world.hands[1].velocity - vec(10, 0, 0)) < 1e-12);
  feed(world, {});
  CHECK(same(world.hands[1].position, vec(2, 0, 0)));
  CHECK(same(world.hands[1].velocity, zero3()));
}

TEST_CASE("pressing and releasing are noticed once each") {
  World world;
  feed(world, move(0, zero3(), true));
  feed(world, move(0, zero3(), true));
  feed(world, move(0, zero3(), false));
  CHECK(kinds(world) == std::vector<Kind>{Kind::press, Kind::release});
  CHECK(world.notices[0].hand == 0);
}

TEST_CASE("a scripted hand follows its path at the end of the step, whatever the input says") {
  World world;
  add_hand(world, [](double t) { return vec(t * t, 0, 0); });
  CHECK(world.hands[0].placed);
  feed(world, move(0, vec(9, 9, 9)), 0.5);
  CHECK(same(world.hands[0].position, vec(0.25, 0, 0)));
  CHECK(same(world.hands[0].velocity, vec(0.5, 0, 0)));
}

TEST_CASE("a path or position that is no number is an error, and a path cannot edit") {
  World world;
  CHECK_THROWS_WITH(feed(world, move(0, vec(0, std::nan(""), 0))), Contains("hand 1: position must be finite"));
  CHECK_THROWS_WITH(feed(world, move(-1, zero3())), Contains("its number must be 1 to"));
  CHECK_THROWS_WITH(add_hand(world, [](double) { return vec(infinity, 0, 0); }), Contains("path must be finite"));
  add_hand(world, [&](double t) {
    if (t > 0.0) add_particle(world, {});
    return zero3();
  });
  CHECK_THROWS_WITH(feed(world, {}), Contains("cannot be edited"));
  CHECK_FALSE(world.locked);
}

TEST_CASE("a grab is a follow with a limit; a new one lets go of the last") {
  Two t;
  feed(t.world, move(0, vec(5, 0, 0)));
  grab(t.world, 0, left_of(t.world, t.a), 30);
  const ConstraintId first = t.world.hands[0].grab;
  CHECK(t.world.constraints[first].max_force == 30.0);
  CHECK(same(t.world.constraints[first].position.now, vec(5, 0, 0)));
  grab(t.world, 0, right_of(t.world, t.b));
  CHECK_FALSE(t.world.constraints.alive(first));
  CHECK(t.world.constraints[t.world.hands[0].grab].a == right_of(t.world, t.b));
  release(t.world, 0);
  release(t.world, 0);
  CHECK(t.world.constraints.empty());
  CHECK(kinds(t.world) == std::vector<Kind>{Kind::grab, Kind::drop, Kind::grab, Kind::drop});
}

TEST_CASE("bad grabs are errors") {
  Two t;
  add_hand(t.world);
  const PointId p = left_of(t.world, t.a);
  CHECK_THROWS_WITH(grab(t.world, 0, p), "grab: hand 1 has no position yet");
  CHECK_THROWS_WITH(grab(t.world, 3, p), Contains("there is no hand 4"));
  CHECK_THROWS_WITH(release(t.world, -1), Contains("there is no hand 0"));
  feed(t.world, move(0, zero3()));
  CHECK_THROWS_WITH(grab(t.world, 0, p, -5), Contains("max_force must be > 0 N"));
  remove(t.world, t.a);
  CHECK_THROWS_WITH(grab(t.world, 0, p), Contains("was removed"));
}

TEST_CASE("a grab that is refused leaves the hand with what it holds") {
  Two t;
  feed(t.world, move(0, zero3()));
  const PointId left = left_of(t.world, t.a), right = right_of(t.world, t.b);
  add_nail(t.world, right);
  grab(t.world, 0, left, infinity);
  const ConstraintId held = t.world.hands[0].grab;
  CHECK_THROWS_WITH(grab(t.world, 0, right, infinity), Contains("is already nailed"));
  CHECK(t.world.hands[0].grab == held);
  CHECK(t.world.constraints.alive(held));
  CHECK_NOTHROW(grab(t.world, 0, left, infinity));  // its own hold is no hindrance
}

TEST_CASE("what is grabbed and removed leaves the hand empty") {
  Two t;
  feed(t.world, move(0, zero3()));
  grab(t.world, 0, left_of(t.world, t.a));
  remove(t.world, t.a);
  CHECK_FALSE(t.world.hands[0].grab);
  CHECK_NOTHROW(release(t.world, 0));
}

TEST_CASE("the usual force lifts all that hangs at the point twenty times over") {
  Two t;
  CHECK(usual_grab_force(t.world, left_of(t.world, t.a)) == Approx(20 * 4 * 9.81));
  cut(t.world, t.hinge);
  CHECK(usual_grab_force(t.world, left_of(t.world, t.a)) == Approx(20 * 2 * 9.81));
  add_rod(t.world, left_of(t.world, t.a), right_of(t.world, t.b));
  CHECK(usual_grab_force(t.world, left_of(t.world, t.a)) == Approx(20 * 4 * 9.81));
  // Without gravity: 2 m s/t² moves 4 kg by 2 m in 0.2 s.
  t.world.settings.gravity = zero3();
  CHECK(usual_grab_force(t.world, left_of(t.world, t.a)) == Approx(2 * 4 * 2 / 0.04));
}

TEST_CASE("commands grab, cut and press keys, and are told as the hand's doing") {
  Two t;
  feed(t.world, move(0, zero3()));
  StepInput input = command(Command::Kind::grab);
  input.commands[0].point = left_of(t.world, t.a);
  input.commands[0].max_force = 7;
  feed(t.world, input);
  CHECK(t.world.constraints[t.world.hands[0].grab].max_force == 7.0);
  input = command(Command::Kind::cut);
  input.commands[0].thing = t.hinge;
  feed(t.world, input);
  CHECK_THROWS_WITH(t.world.particles[t.hinge], Contains("was removed at 0.2 s by hand 1"));
  CHECK(t.world.notices.back().kind == Kind::cut);
  CHECK(t.world.notices.back().hand == 0);
  feed(t.world, command(Command::Kind::release));
  CHECK_FALSE(t.world.hands[0].grab);
  input = command(Command::Kind::key);
  input.commands[0].name = "space";
  feed(t.world, input);
  CHECK(t.world.notices.back().kind == Kind::key);
  CHECK(t.world.notices.back().text == "space");
  CHECK_FALSE(t.world.who);
}

TEST_CASE("a command on a thing that is gone is dropped and logged") {
  Two t;
  feed(t.world, move(0, zero3()));
  StepInput input = command(Command::Kind::cut);
  input.commands[0].thing = t.hinge;
  cut(t.world, t.hinge);
  CHECK_NOTHROW(feed(t.world, input));
  REQUIRE(t.world.log.size() == 1);
  CHECK(t.world.log[0].kind == "dropped");
  CHECK_THAT(t.world.log[0].text, Contains("cut by hand 1") && Contains("was removed at 0.1 s"));
  CHECK_NOTHROW(feed(t.world, command(Command::Kind::release, 8)));
  CHECK(t.world.log.size() == 2);
}

TEST_CASE("the velocity of a followed target is exact for a parabola once there are three samples") {
  World world;
  FollowDef def;
  def.target = [](double t) { return vec(1 + 2 * t + 3 * t * t, 0, 0); };
  def.max_force = 10;
  const ConstraintId id = add_follow(world, point_of(world, add_particle(world, {})), def);
  feed(world, {});
  const Constraint& c = world.constraints[id];
  CHECK(same(c.position.previous, vec(1, 0, 0)));
  CHECK(c.position.now[0] == Approx(1.23));
  CHECK(c.position.rate[0] == Approx(2.3));
  feed(world, {});
  CHECK(c.position.previous[0] == Approx(1.23));
  CHECK(c.position.rate[0] == Approx(2 + 6 * 0.2));
  def.target = [](double t) { return t > 0.25 ? vec(0, std::nan(""), 0) : zero3(); };
  set_target(world, id, def.target);
  CHECK_THROWS_WITH(feed(world, {}), Contains("follow") && Contains("target must be finite"));
}

TEST_CASE("a nail from far away draws its point in, critically damped, without overshoot") {
  World world;
  const PointId point = point_of(world, add_particle(world, {}));
  set_velocity(world, point, vec(0, 0, 1));
  const double tau = 0.25;
  const ConstraintId id = add_nail(world, point, vec(2, 0, 0), tau);
  // x'' + 2 x'/tau + x/tau² = 0, solved by x = (x0 + (v0 + x0/tau) t) exp(-t/tau)
  for (int i = 1; i <= 20; i++) {
    feed(world, {}, 0.05);
    const double t = 0.05 * i, decay = std::exp(-t / tau);
    const Constraint& c = world.constraints[id];
    CHECK(c.attract.away[0] == Approx(-2 * (1 + t / tau) * decay));
    CHECK(c.attract.away[2] == Approx(t * decay));
    CHECK(c.attract.away_rate[0] == Approx(2 * t / (tau * tau) * decay));
    CHECK(c.attract.away_rate[2] == Approx((1 - t / tau) * decay).margin(1e-14));
  }
  for (int i = 0; i < 400; i++) feed(world, {}, 0.05);
  CHECK(same(world.constraints[id].attract.away, zero3()));
  CHECK(same(world.constraints[id].attract.away_rate, zero3()));
}

TEST_CASE("a follow that an event makes is at its target at the end of that step") {
  World world;
  world.settings.gravity = zero3();
  const ParticleId particle = add_particle(world, {});
  const PointId point = world.particles[particle].points[0];
  ConstraintId follow;
  Event event;
  event.time = 0.1;
  event.action = [&] {
    FollowDef def;
    def.target = [](double time) { return vec(time, 0, 0); };
    follow = add_follow(world, point, def);
    set_step(world, 1.0 / 60);
  };
  add_event(world, event);
  while (!follow) step(world);
  CHECK(world.constraints[follow].position.now[0] == world.time);
  CHECK(norm(world.constraints[follow].position.rate - vec(1, 0, 0)) <= 1e-12);
}
