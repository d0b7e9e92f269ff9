// Gears, racks, pulleys and screws: values of two things in a fixed proportion, held against closed forms.
#include "edit/coupling_constraints.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "articulates/solve/momenta.hpp"
#include "constraints/kind.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "model/path.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

constexpr double pi = 3.14159265358979323846;

/// A disc in the xy plane, at a position, with a moment about z [kg m²].
BodyId add_disc(World& world, Vec3 at, double moment, double mass = 1.0) {
  BodyDef def;
  def.at = at;
  def.mass = mass;
  def.inertia = diagonal(vec(0.5 * moment, 0.5 * moment, moment));
  def.points.emplace_back();
  def.points.emplace_back();
  def.points.back().at = vec(0.1, 0, 0);
  return add_body(world, def);
}

PointId add_mass(World& world, Vec3 at, double mass) {
  ParticleDef def;
  def.at = at;
  def.mass = mass;
  return world.particles[add_particle(world, def)].points[0];
}

PointId centre(const World& world, BodyId body) { return world.bodies[body].points[0]; }

double spin_of(const World& world, BodyId body) { return angular_velocity(world.motion_of(body))[2]; }

/// A wheel on an axle of the world.
BodyId add_wheel(World& world, Vec3 at, double moment) {
  const BodyId wheel = add_disc(world, at, moment);
  add_nail(world, centre(world, wheel));
  if (world.plane.flat()) return wheel;
  AlignDef along;
  along.axis_a = along.axis_b = vec(0, 0, 1);
  along.angle = 0.0;
  add_align(world, wheel, {}, along);
  return wheel;
}

GearDef gear_of(double ratio) {
  GearDef def;
  def.axis_a = vec(0, 0, 1);
  def.ratio.value = ratio;
  return def;
}

/// How far turns by `turned` rad a step may be from those of a motion without steps: a step's turn is 2 atan(ω h/2).
double error_of_turns(double turned) { return turned * turned / 12.0; }

}  // namespace

TEST_CASE("gear: a torque on one wheel turns both, as their moments say") {
  const double ratio = GENERATE(-2.0, 1.0, 0.3);
  const bool flat = GENERATE(false, true);
  INFO(ratio << " " << flat);
  World world;
  if (flat) set_plane(world, Plane{2});
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0);
  const ConstraintId gear = add_gear(world, a, b, gear_of(ratio));
  const double torque = 3.0, rate = torque / (0.5 + 2.0 / (ratio * ratio));  // [rad/s²] of a
  while (world.time < 2.0 - 1e-9) {
    twist(world, a, vec(0, 0, torque));
    step(world);
  }
  const double fastest = rate * 2.0 * std::fmax(1.0, std::fabs(1.0 / ratio)),
               wrong = error_of_turns(fastest * world.settings.step);
  CHECK(spin_of(world, a) == Approx(rate * 2.0).epsilon(wrong));
  CHECK(spin_of(world, b) == Approx(rate * 2.0 / ratio).epsilon(wrong));
  CHECK(present_gap(world, world.constraints[gear]) <= 1e-10);
  const double of_a_step =
      0.5 * fastest * wrong / world.settings.step;  // what such an error of the spin is as a torque
  CHECK(world.constraints[gear].torque[2] == Approx(rate * 0.5 - torque).margin(2.0 * of_a_step));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("gear: many turns lose no energy and no tooth") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0),
               c = add_wheel(world, vec(2, 0, 0), 0.1);
  add_gear(world, a, b, gear_of(-3.0));
  const ConstraintId last = add_gear(world, b, c, gear_of(-0.2));
  set_spin(world, a, vec(0, 0, 30));
  step(world);
  const double before = energy(world).kinetic, turned = spin_of(world, a);
  advance(world, 20.0);
  CHECK(energy(world).kinetic == Approx(before).epsilon(1e-9));
  CHECK(spin_of(world, a) == Approx(turned).epsilon(1e-9));
  CHECK(spin_of(world, b) == Approx(turned / -3.0).epsilon(1e-9));
  CHECK(spin_of(world, c) == Approx(turned / -3.0 / -0.2).epsilon(1e-9));
  CHECK(present_gap(world, world.constraints[last]) <= 1e-9);
}

TEST_CASE("gear: a loop of gears that agree is no contradiction") {
  World world;
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0),
               c = add_wheel(world, vec(2, 0, 0), 0.1);
  add_gear(world, a, b, gear_of(2.0));
  add_gear(world, b, c, gear_of(3.0));
  add_gear(world, a, c, gear_of(6.0));
  set_spin(world, a, vec(0, 0, 5));
  advance(world, 5.0);
  CHECK(spin_of(world, c) == Approx(spin_of(world, a) / 6.0).epsilon(1e-8));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("gear: on a carrier that floats freely angular momentum and energy stay") {
  World world;
  world.settings.gravity = zero3();
  const BodyId carrier = add_disc(world, vec(0, 0, 0), 4.0, 3.0), a = add_disc(world, vec(0, 0, 0), 0.5),
               b = add_disc(world, vec(0.1, 0, 0), 0.2);
  const auto axle = [&](std::size_t of, BodyId wheel) {
    HingeDef def;
    def.axis = vec(0, 0, 1);
    const PointId ring[] = {world.bodies[carrier].points[of], centre(world, wheel)};
    add_hinge(world, ring, def);
  };
  axle(0, a);
  axle(1, b);
  GearDef def = gear_of(-2.0);
  def.carrier = carrier;
  add_gear(world, a, b, def);
  set_spin(world, a, vec(0.2, 0.1, 20));
  step(world);
  const Things all = everything(world);
  const double before = energy(world).kinetic;
  const Vec3 turning = angular_momentum(world, all);
  advance(world, 10.0);
  CHECK(energy(world).kinetic == Approx(before).epsilon(1e-10));
  CHECK(norm(angular_momentum(world, all) - turning) <= 1e-9 * norm(turning));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("gear: a ratio that changes in time leaves the wheels where they are, and their power with each other") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0);
  GearDef def = gear_of(1.0);
  def.ratio.function = [](double t) { return 1.0 + 0.5 * t; };
  add_gear(world, a, b, def);
  set_spin(world, b, vec(0, 0, 4));
  set_spin(world, a, vec(0, 0, 4));
  step(world);
  // (I_a r² + I_b) ω_b²/2 is kept: the gear does no work
  const double kept = energy(world).kinetic;
  advance(world, 2.0);
  CHECK(energy(world).kinetic == Approx(kept).epsilon(1e-4));
  CHECK(spin_of(world, a) / spin_of(world, b) == Approx(2.0).epsilon(1e-6));
}

TEST_CASE("gear: edits of each step take nothing where the ratio changes in time") {
  const int steps_in_a_second = GENERATE(60, 240);
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / steps_in_a_second;
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0);
  GearDef def = gear_of(2.0);
  def.ratio.function = [](double t) { return 2.0 + std::sin(2.0 * t); };
  add_gear(world, a, b, def);
  set_spin(world, b, vec(0, 0, 4));
  set_spin(world, a, vec(0, 0, 8));
  step(world);
  const double kept = energy(world).kinetic;
  for (int k = 0; k < 5 * steps_in_a_second; k++) {
    set_spin(world, a, vec(0, 0, spin_of(world, a)));
    step(world);
  }
  CHECK(energy(world).kinetic == Approx(kept).epsilon(1e-10));
}

TEST_CASE("gear: breaks at the torque on its first wheel, which it tells") {
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0);
  const ConstraintId gear = add_gear(world, a, b, gear_of(-2.0));
  Breaking at;
  at.torque = 1.0;
  set_breaks_at(world, gear, at);
  double told = 0.0;
  while (world.constraints.alive(gear) && world.time < 2.0) {
    told = norm(world.constraints[gear].torque);
    twist(world, a, vec(0, 0, 5.0 * world.time));
    step(world);
  }
  CHECK(told <= 1.0);
  CHECK(world.time == Approx(0.4).margin(2.5 * world.settings.step));  // half of 5 N m/s goes to b, twice that is on b
}

TEST_CASE("gear: the gap that is told of gears that contradict is the one that is there") {
  const double ratio = GENERATE(1e-6, 0.3, 2.0, 1e6);
  World world;
  world.settings.gravity = zero3();
  const BodyId a = add_wheel(world, vec(0, 0, 0), 0.5), b = add_wheel(world, vec(1, 0, 0), 2.0);
  const ConstraintId gears[] = {add_gear(world, a, b, gear_of(ratio)), add_gear(world, a, b, gear_of(2.0 * ratio))};
  set_spin(world, a, vec(0, 0, 5));
  for (int k = 0; k < 20; k++) step(world);
  double there = 0.0;
  for (ConstraintId gear : gears) there = std::fmax(there, present_gap(world, world.constraints[gear]));
  CHECK(world.error.constraint == Approx(there).epsilon(0.05).margin(1e-12));
}

TEST_CASE("rack: a rack that falls turns its wheel") {
  World world;
  const BodyId wheel = add_wheel(world, vec(0, 0, 0), 0.4);
  const PointId point = add_mass(world, vec(0.5, 0, 0), 2.0);
  RackDef def;
  def.axis = vec(0, 0, 1);
  def.along = vec(0, 1, 0);
  def.radius.value = 0.5;
  add_rack(world, wheel, point, def);
  const double fall = 2.0 * -9.81 / (2.0 + 0.4 / 0.25);
  advance(world, 1.0);
  const double wrong = error_of_turns(fall / 0.5 * world.settings.step);
  CHECK(world.motion_of(point).v[1] == Approx(fall).epsilon(wrong));
  CHECK(position(world, point)[1] == Approx(0.5 * fall).epsilon(wrong));
  CHECK(spin_of(world, wheel) == Approx(world.motion_of(point).v[1] / 0.5).epsilon(1e-12));
}

TEST_CASE("pulley: two masses on a tackle fall as their weights say, and the rope may go slack") {
  const double ratio = GENERATE(1.0, 2.0);
  World world;
  const PointId a = add_mass(world, vec(0, -2, 0), 3.0), b = add_mass(world, vec(1, -2, 0), 1.0);
  PulleyDef def;
  def.ratio.value = ratio;
  const ConstraintId rope = add_pulley(world, a, {{}, vec(0, 0, 0)}, b, {{}, vec(1, 0, 0)}, def);
  const double pull = 9.81 * (1.0 + ratio) / (1.0 / 3.0 + ratio * ratio), down = pull / 3.0 - 9.81;
  advance(world, 0.25);
  CHECK(world.motion_of(a).v[1] == Approx(down * 0.25).epsilon(1e-9));
  CHECK(world.motion_of(b).v[1] == Approx(-down * 0.25 / ratio).epsilon(1e-9));
  CHECK(world.constraints[rope].tension == Approx(pull).epsilon(1e-9));
  CHECK(present_gap(world, world.constraints[rope]) <= 1e-10);
  kick(world, a, vec(0, 10, 0));
  advance(world, 0.45);
  CHECK(world.motion_of(b).v[1] < 0.0);  // it falls freely
  CHECK(std::fabs(world.constraints[rope].tension) <= 1e-9);
}

TEST_CASE("pulley: a side whose ends have become one body is as long as it was, and the other one hangs from it") {
  World world;
  const BodyId first = add_disc(world, vec(0, 3, 0), 1.0), second = add_disc(world, vec(1, 3, 0), 1.0);
  add_nail(world, centre(world, first));
  add_orient(world, first);
  const PointId hanging = add_mass(world, vec(3, 3, 0), 2.0);
  const bool fixed_first = GENERATE(true, false);
  PulleyDef def;
  def.ratio.value = 4.0;
  const Passage over{centre(world, second), zero3()}, wheel{{}, vec(3, 5, 0)};
  const ConstraintId rope = fixed_first ? add_pulley(world, centre(world, first), over, hanging, wheel, def)
                                        : add_pulley(world, hanging, wheel, centre(world, first), over, def);
  merge(world, first, second);
  advance(world, 1.0);
  CHECK(norm(world.motion_of(hanging).x - vec(3, 3, 0)) <= 1e-12);
  CHECK(world.constraints[rope].tension == Approx(2.0 * 9.81 / (fixed_first ? 4.0 : 1.0)).epsilon(1e-9));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("screw: a nut that falls along its screw turns") {
  World world;
  const double moment = 0.3, lead = 0.5, per = 2.0 * pi / lead;
  const BodyId screw = add_disc(world, vec(0, 0, 0), 1.0), nut = add_disc(world, vec(0, 0, -2), moment, 2.0);
  set_gravity(world, vec(0, 0, -9.81));
  add_nail(world, centre(world, screw));
  add_orient(world, screw);
  add_on_path(world, centre(world, nut),
              std::make_shared<const Path>(std::vector<Vec3>{vec(0, 0, -50), vec(0, 0, 0)}, false, false));
  AlignDef along;
  along.axis_a = along.axis_b = vec(0, 0, 1);
  along.angle = 0.0;
  add_align(world, nut, {}, along);
  ScrewDef def;
  def.axis = vec(0, 0, 1);
  def.lead.value = lead;
  add_screw(world, centre(world, nut), centre(world, screw), def);
  const double fall = 2.0 * 9.81 / (2.0 + moment * per * per);
  advance(world, 1.0);
  const double wrong = error_of_turns(fall * per * world.settings.step);
  CHECK(world.motion_of(nut).x[2] == Approx(-2.0 - 0.5 * fall).epsilon(wrong));
  CHECK(spin_of(world, nut) == Approx(-fall * per).epsilon(wrong));
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("screw: a nut passes the point it counts from, on the axis and beside it, and turns on") {
  World world;
  world.settings.gravity = zero3();
  const double lead = 0.5, spin = 4.0, speed = -spin * lead / (2.0 * pi), start = GENERATE(0.2, 1e-3, 0.0),
               beside = GENERATE(0.0, 1e-5, 0.3);
  INFO(start << " " << beside);
  const BodyId screw = add_wheel(world, vec(0, 0, 0), 0.3), nut = add_disc(world, vec(beside, 0, start), 0.3, 2.0);
  add_orient(world, nut);
  add_on_path(world, centre(world, nut),
              std::make_shared<const Path>(std::vector<Vec3>{vec(beside, 0, -50), vec(beside, 0, 50)}, false, false));
  ScrewDef def;
  def.axis = vec(0, 0, 1);
  def.lead.value = lead;
  add_screw(world, centre(world, nut), centre(world, screw), def);
  set_spin(world, screw, vec(0, 0, -spin));
  set_velocity(world, nut, vec(0, 0, speed));
  step(world);
  const double kept = energy(world).kinetic, first = velocity(world, centre(world, nut))[2];
  advance(world, 2.0 + world.settings.step);
  CHECK(std::fabs(first) > 0.9 * std::fabs(speed));
  CHECK(world.motion_of(nut).x[2] == Approx(start + first * (2.0 + world.settings.step)).margin(1e-4));
  CHECK(velocity(world, centre(world, nut))[2] == Approx(first).epsilon(1e-10));
  CHECK(energy(world).kinetic == Approx(kept).epsilon(1e-10));
  CHECK(world.worst.constraint <= 1e-10);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("couplings: of bodies that tumble freely momentum, angular momentum and energy stay") {
  const bool of_screw = GENERATE(true, false);
  World world;
  world.settings.gravity = zero3();
  const auto add = [&](Vec3 at, Vec3 moments, double mass) {
    BodyDef def;
    def.at = at;
    def.mass = mass;
    def.inertia = diagonal(moments);
    def.points.emplace_back();
    return add_body(world, def);
  };
  const BodyId a = add(vec(0.2, 1, 0), vec(0.3, 0.2, 0.4), 2.0), b = add(vec(0, 0, 0), vec(0.5, 0.6, 0.7), 3.0),
               c = add(vec(1, 0, 0), vec(0.2, 0.2, 0.3), 1.0);
  ScrewDef screw;
  screw.axis = vec(0, 1, 0);
  screw.lead.value = 0.5;
  RackDef rack;
  rack.axis = vec(0, 1, 0);
  rack.along = vec(1, 0, 0);
  rack.radius.value = 0.4;
  rack.carrier = b;
  if (of_screw)
    add_screw(world, centre(world, a), centre(world, b), screw);
  else
    add_rack(world, a, centre(world, c), rack);
  set_spin(world, a, vec(0.3, 5, -0.2));
  set_spin(world, b, vec(0.1, -1, 0.4));
  set_velocity(world, a, vec(0, 0.1, 0));
  set_velocity(world, b, vec(-0.2, 0.3, 0.1));
  step(world);
  for (const auto& articulate : world.articulates) CHECK(is_free(*articulate));
  const Things all = everything(world);
  const double kept = energy(world).kinetic;
  const Vec3 momentum = pantin::momentum(world, all), turning = angular_momentum(world, all);
  advance(world, 3.0);
  CHECK(energy(world).kinetic == Approx(kept).epsilon(1e-10));
  CHECK(norm(pantin::momentum(world, all) - momentum) <= 1e-12);
  CHECK(norm(angular_momentum(world, all) - turning) <= 1e-9);
  CHECK(world.stats.fallback_steps == 0);
}

TEST_CASE("gear: about axes that tilt it does no work, however slowly it turns") {
  const double slow = GENERATE(1.0, 0.1, 0.01);
  World world;
  world.settings.gravity = zero3();
  BodyDef def;
  def.mass = 1.0;
  def.inertia = diagonal(vec(0.3, 0.2, 0.4));
  def.points.emplace_back();
  const BodyId a = add_body(world, def), b = add_wheel(world, vec(3, 0, 0), 0.5);
  add_nail(world, centre(world, a));
  set_spin(world, a, vec(0.5, 0, 1) * slow);
  set_spin(world, b, vec(0, 0, slow));
  add_gear(world, a, b, gear_of(1.0));
  step(world);
  const double kept = energy(world).kinetic;
  advance(world, 2.0 / slow);
  CHECK(spin_of(world, b) / slow == Approx(1.07747699).epsilon(1e-7));  // by RK4 with the force from the accelerations
  CHECK(energy(world).kinetic == Approx(kept).epsilon(1e-9));
}

TEST_CASE("couplings: what they tell does not change with a limit that is never met") {
  const bool limited = GENERATE(false, true);
  INFO(limited);
  World world;
  const BodyId wheel = add_wheel(world, vec(0, 0, 0), 0.1);
  const PointId point = add_mass(world, vec(0.5, 0, 0), 2.0);
  RackDef def;
  def.axis = vec(0, 0, 1);
  def.along = vec(0, 1, 0);
  def.radius.value = 0.5;
  const ConstraintId rack = add_rack(world, wheel, point, def);
  LimitDef limit;
  limit.max = 1e6;
  if (limited) add_limit(world, wheel, BodyId{}, vec(0, 0, 1), limit);
  advance(world, 3.0);
  const double fall = 2.0 * -9.81 / (2.0 + 0.1 / 0.25);
  CHECK(world.constraints[rack].force[1] == Approx(2.0 * (fall + 9.81)).epsilon(0.03));
}

TEST_CASE("pulley: a rope that is too short attracts what it ties") {
  World world;
  const PointId a = add_mass(world, vec(0, 2, 0), 1.0), b = add_mass(world, vec(1, 1, 0), 1.0);
  PulleyDef def;
  def.length = 3.0;
  const ConstraintId rope = add_pulley(world, a, {{}, vec(0, 4, 0)}, b, {{}, vec(1, 4, 0)}, def);
  const auto length = [&] { return 8.0 - position(world, a)[1] - position(world, b)[1]; };
  step(world);
  CHECK(length() > 4.9);
  advance(world, 2.0);
  CHECK(length() == Approx(3.0).epsilon(1e-3));
  set_rope_length(world, rope, 2.5);
  step(world);
  CHECK(length() > 2.9);
  advance(world, 4.0);
  CHECK(length() == Approx(2.5).epsilon(1e-3));
  CHECK(world.stats.fallback_steps == 0);
  CHECK_THROWS_WITH(set_rope_length(world, rope, -1.0), Catch::Contains("length must be > 0 m"));
}

TEST_CASE("couplings: what cannot be is an error") {
  World world;
  const BodyId a = add_disc(world, vec(0, 0, 0), 1.0), b = add_disc(world, vec(1, 0, 0), 1.0);
  CHECK_THROWS_WITH(add_gear(world, a, a, gear_of(1.0)), Catch::Contains("it needs two bodies"));
  CHECK_THROWS_WITH(add_gear(world, a, b, gear_of(0.0)), Catch::Contains("ratio must not be 0"));
  CHECK_THROWS_WITH(add_gear(world, a, b, {}), Catch::Contains("axis must not be vec(0, 0, 0)"));
  GearDef own = gear_of(1.0);
  own.carrier = a;
  CHECK_THROWS_WITH(add_gear(world, a, b, own), Catch::Contains("cannot turn against itself"));
  CHECK(world.constraints.size() == 0);
}
