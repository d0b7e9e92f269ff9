// Articulates fall asleep once their motion has died away, and cost nothing until something moves them again.
#include "forces/sleep.hpp"
#include "measure/ledger_closure.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "choreography/hands.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

constexpr double pi = std::numbers::pi;

double line(const World& world, Source source) { return world.ledger.given[static_cast<std::size_t>(source)]; }

std::shared_ptr<const Law> resting_law(const char* name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  return std::make_shared<Law>(make_library_law(name, arguments).front());
}

FieldId drag(World& world, double linear) { return add_field(world, resting_law("drag", {{"linear", linear}}), {}); }

/// A pendulum of one rod on a nail at `at`, turned by `angle` [rad] from hanging straight down.
BodyId add_pendulum(World& world, Vec3 at = zero3(), double angle = 0.0) {
  BodyDef def;
  def.at = at + vec(0.5 * std::sin(angle), -0.5 * std::cos(angle), 0);
  const double half = 0.5 * angle - 0.25 * pi;
  def.orientation = {std::cos(half), 0, 0, std::sin(half)};
  const BodyId rod = cases::add_rod_body(world, 1, 1, def);
  add_nail(world, cases::point_of(world, rod, 0));
  return rod;
}

void steps(World& world, int count) {
  for (int i = 0; i < count; i++) step(world);
  REQUIRE(world.failure == "");
}

bool asleep(const World& world, BodyId body) {
  return world.articulates[static_cast<std::size_t>(world.motion_of(body).articulate)]->rest.asleep;
}

/// Two pendulums that sleep.
struct Asleep {
  World world;
  BodyId rod = add_pendulum(world), other = add_pendulum(world, vec(5, 0, 0));
  PointId tail = cases::point_of(world, rod, 1);
  /// `tied`: to what, before they fall asleep.
  explicit Asleep(const std::function<void(Asleep&)>& tied = {}) {
    if (tied) tied(*this);
    steps(world, 1500);
    REQUIRE(sleepers(world) == world.articulates.size());
  }
  /// The first has been woken, within so many steps; the other sleeps on.
  void check_woken(int within = 1) {
    steps(world, within);
    CHECK(!asleep(world, rod));
    CHECK(asleep(world, other));
  }
};

/// Two loose balls on a spring without tension, which explicit steps of 1/240 s cannot follow from 7 s on.
ConnectionId add_stiffening_spring(World& world) {
  Expressions g;
  const Expr t = g.input({Role::time, 0, 0, {}}), t2 = g.multiply(t, t), t4 = g.multiply(t2, t2);
  const Expr stretch = g.add(g.square_root(g.input({Role::distance2, 0, 0, {}})), g.constant(-1.0));
  LawDef law;
  law.name = "stiffening";
  ConnectionDef def;
  for (double x : {10.0, 11.0}) {
    ParticleDef ball;
    ball.at = vec(x, 0, 0);
    ball.mass = 1;
    def.ends.push_back({add_particle(world, ball)});
  }
  const Expr stiffness = g.scale(g.multiply(t4, t4), 0.0125), energy = g.multiply(stretch, stretch);
  return add_connection(world, std::make_shared<Law>(central_potential(law, g, g.multiply(stiffness, energy))), def);
}

}  // namespace

TEST_CASE("sleep: a damped chain falls asleep where it came to rest, is not solved then, and the ledger closes") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 4});
  drag(world, 4.0);
  keep_ledger(world);
  advance(world, 12.0);
  CHECK(sleepers(world) == 0);
  advance(world, 60.0);
  REQUIRE(sleepers(world) == 1);
  CHECK(closure(world) <= 1e-10);
  CHECK(energy(world).kinetic == 0.0);
  CHECK(line(world, Source::sleep) < 0.0);
  CHECK(line(world, Source::sleep) >= -1e-15);
  CHECK(world.error.energy <= 1e-4);
  for (std::size_t i = 0; i < 4; i++)
    CHECK(norm(world.motion_of(chain.bodies[i]).x - vec(0, -0.5 - static_cast<double>(i), 0)) <= 1e-7);
  const Stats before = world.stats;
  const Motion last = world.motion_of(chain.bodies.back());
  const double force = norm(world.constraints[chain.pin].force);
  CHECK(force == Approx(4 * 9.81).epsilon(1e-7));
  steps(world, 100);
  CHECK(world.stats.solves == before.solves);
  CHECK(norm(world.motion_of(chain.bodies.back()).x - last.x) == 0.0);
  CHECK(norm(world.constraints[chain.pin].force) == force);
  CHECK(closure(world) <= 1e-10);
}

TEST_CASE("sleep: what swings undamped never does, however little, nor at its turning points") {
  for (const double angle : {1.0, 1e-3, 1e-6}) {
    World world;
    add_pendulum(world, zero3(), angle);
    add_pendulum(world, vec(3, 0, 0), pi - angle);
    for (int i = 0; i < 240 * 20; i++) {
      step(world);
      REQUIRE(sleepers(world) == 0);
    }
  }
}

TEST_CASE("sleep: what stands nearly on its head falls when it would have fallen") {
  for (const double angle : {1e-9, 1e-11, 1e-13}) {
    CAPTURE(angle);
    World world, watched;
    const BodyId falls = add_pendulum(world, zero3(), pi - angle), same = add_pendulum(watched, zero3(), pi - angle);
    for (int i = 0; i < 240 * 15; i++) {
      step(world);
      wake_all(watched);
      step(watched);
      REQUIRE(sleepers(world) == 0);
    }
    CHECK(world.largest_kinetic > 1.0);
    CHECK(state_hash(world) == state_hash(watched));
    CHECK(norm(world.motion_of(falls).x - watched.motion_of(same).x) == 0.0);
  }
}

TEST_CASE("sleep: a top that stands and spins does not") {
  World world;
  BodyDef def;
  def.points.resize(2);
  def.points[0].at = vec(0, -1, 0);
  def.points[1].mass = 1;
  def.inertia = Mat3{vec(0.1, 0, 0), vec(0, 0.2, 0), vec(0, 0, 0.1)};
  def.spin = vec(0, 100, 0);
  const BodyId top = add_body(world, def);
  add_nail(world, cases::point_of(world, top, 0));
  for (int i = 0; i < 2400; i++) {
    step(world);
    REQUIRE(sleepers(world) == 0);
  }
}

TEST_CASE("sleep: pushes, kicks, twists and moves wake what they move, and no other") {
  const auto wakes = [](const std::function<void(Asleep&)>& act) {
    Asleep scene;
    act(scene);
    scene.check_woken();
    steps(scene.world, 1);
    CHECK(energy(scene.world).kinetic > 0.0);
  };
  wakes([](Asleep& s) { push(s.world, s.rod, vec(1, 0, 0)); });
  wakes([](Asleep& s) { push(s.world, s.tail, vec(1, 0, 0)); });
  wakes([](Asleep& s) { kick(s.world, s.rod, vec(1, 0, 0)); });
  wakes([](Asleep& s) { twist(s.world, s.rod, vec(0, 0, 1)); });
  wakes([](Asleep& s) { set_velocity(s.world, s.rod, vec(1, 0, 0)); });
  wakes([](Asleep& s) { set_orientation(s.world, s.rod, {1, 0, 0, 0}); });
}

TEST_CASE("sleep: a hand, a nail and another mass wake what they hold") {
  Asleep grabbed;
  const std::int32_t hand = add_hand(grabbed.world, [](double t) { return vec(t, -1, 0); });
  steps(grabbed.world, 1);
  CHECK(asleep(grabbed.world, grabbed.rod));
  grab(grabbed.world, hand, grabbed.tail);
  grabbed.check_woken();

  Asleep nailed;
  add_nail(nailed.world, nailed.tail);
  nailed.check_woken();

  Asleep heavier;
  set_own_mass(heavier.world, heavier.rod, 2.0);
  heavier.check_woken();
}

TEST_CASE("sleep: a nail that goes has the rod fall, and gravity that turns wakes all") {
  Asleep cut;
  for (const ConstraintId nail : cut.world.constraints.ids()) remove(cut.world, nail);
  steps(cut.world, 24);
  CHECK(cut.world.motion_of(cut.rod).x[1] < -0.54);

  Asleep turned;
  set_gravity(turned.world, vec(9.81, 0, 0));
  steps(turned.world, 1);
  CHECK(sleepers(turned.world) == 0);
  CHECK(energy(turned.world).kinetic > 0.0);
}

TEST_CASE("sleep: targets that move and constraints that change wake, those that stay let sleep") {
  ConstraintId follow;
  const auto held = [&](Asleep& s) {
    follow = add_follow(s.world, s.tail, {.target = [](double t) { return vec(t < 10 ? 0 : t - 10, -1, 0); }});
  };
  Asleep moved(held);
  while (next_time(moved.world) <= 10) {
    steps(moved.world, 1);
    CHECK(asleep(moved.world, moved.rod));
  }
  moved.check_woken();

  Asleep placed(held);
  set_position(placed.world, follow, vec(0.1, -1, 0));
  placed.check_woken();

  Asleep motored([&](Asleep& s) {
    MotorDef def;
    def.axis = vec(0, 0, 1);
    def.speed = 0.0;
    follow = add_motor(s.world, s.rod, {}, def);
  });
  set_length(motored.world, follow, 0.5);
  motored.check_woken();
  steps(motored.world, 2400);  // it goes on turning
  CHECK(!asleep(motored.world, motored.rod));
}

TEST_CASE("sleep: a spring that a particle is hung on wakes it when the particle is moved or its stiffness changed") {
  for (const Solve solve : {Solve::explicitly, Solve::at_middle}) {
    CAPTURE(solve == Solve::explicitly);
    ConnectionId spring;
    Asleep scene([&](Asleep& s) {
      ConnectionDef def;
      def.ends = {{s.world.points[s.tail].own, zero3()}, {{}, vec(0, -1.5, 0)}};
      def.parameters = {};
      def.solve = solve;
      spring = add_connection(s.world, resting_law("spring", {{"stiffness", 1.0}, {"length", 0.4}}), def);
    });
    const auto& names = scene.world.connections[spring].law->parameters;
    for (std::size_t i = 0; i < names.size(); i++)
      if (names[i].name == "length") set_parameter(scene.world, spring, i, 0.6);
    steps(scene.world, 1);
    CHECK(!asleep(scene.world, scene.rod));
    CHECK(asleep(scene.world, scene.other));
  }
}

TEST_CASE("sleep: a body that comes near with a law of pairs wakes it, and momentum is kept") {
  World world;
  world.settings.gravity = zero3();
  FamilyDef charged;
  charged.name = "charged";
  const FamilyId family = add_family(world, charged);
  BodyDef def;
  def.points.resize(2);
  def.points[0].mass = def.points[1].mass = 1;
  def.points[1].at = vec(1, 0, 0);
  def.points[1].family = family;
  const BodyId a = add_body(world, def);
  def.at = vec(-1, 0, 0);
  def.points[1].family = {};
  const BodyId b = add_body(world, def);
  add_hinge(world, std::vector<PointId>{cases::point_of(world, a, 0), cases::point_of(world, b, 1)});
  add_interaction(world, resting_law("yukawa", {{"strength", 1.0}, {"screening", 0.05}}), family, family);
  ParticleDef ball;
  ball.family = family;
  ball.at = vec(8, 0, 0);
  ball.velocity = vec(-1, 0, 0);
  const ParticleId flying = add_particle(world, ball);
  keep_ledger(world);
  steps(world, 720);
  CHECK(sleepers(world) == 1);
  CHECK(norm(velocity(world, flying) - ball.velocity) == 0.0);
  steps(world, 1200);
  CHECK(sleepers(world) == 0);
  CHECK(velocity(world, flying)[0] > -0.9);
  CHECK(norm(momentum(world, everything(world)) - vec(-1, 0, 0)) <= 1e-9);  // what was too weak to wake it
  CHECK(closure(world) <= 1e-10);
  CHECK(world.error.energy <= 1e-4);
}

TEST_CASE("sleep: springs that become solved by themselves wake what fell asleep in other laws than act now") {
  ConnectionId spring;
  Asleep scene([&](Asleep& s) { spring = add_stiffening_spring(s.world); });
  World& world = scene.world;
  Articulate& articulate = *world.articulates[static_cast<std::size_t>(world.motion_of(scene.rod).articulate)];
  articulate.rest.receivers++;  // as if a law had pulled at it then
  steps(world, 100);
  REQUIRE(world.connections[spring].solve == Solve::explicitly);
  REQUIRE(asleep(world, scene.rod));
  for (int i = 0; i < 300 && world.connections[spring].solve == Solve::explicitly; i++) steps(world, 1);
  REQUIRE(world.connections[spring].solve == Solve::at_middle);
  CHECK(!asleep(world, scene.rod));
  CHECK(asleep(world, scene.other));
}

TEST_CASE("sleep: where all sleep no phase has work, and time goes on") {
  Asleep scene;
  const double time = scene.world.time;
  const std::uint64_t instant = scene.world.instant;
  steps(scene.world, 240);
  CHECK(all_asleep(scene.world));
  CHECK(scene.world.instant == instant);
  CHECK(scene.world.time == Approx(time + 1.0));
}

TEST_CASE("sleep: the same bits by any number of threads, and with every integrator that moves hinges") {
  for (const Integrator integrator : {Integrator::verlet, Integrator::implicit, Integrator::euler}) {
    std::uint64_t hashes[2];
    for (int threads = 1; threads <= 2; threads++) {
      World world;
      world.workers = std::make_unique<Workers>(threads);
      world.settings.step = 1.0 / 120;
      for (int i = 0; i < 5; i++) cases::add_chain(world, {.links = 2, .start = vec(0, 0, i)});
      drag(world, 2.0);
      set_integrator(world, integrator);
      steps(world, 120 * 15);
      CHECK(sleepers(world) == 5);
      kick(world, world.bodies.ids()[7], vec(0, 0, 1));
      steps(world, 10);
      CHECK(sleepers(world) == 4);
      hashes[threads - 1] = state_hash(world);
    }
    CHECK(hashes[0] == hashes[1]);
  }
}

TEST_CASE("sleep: a snapshot of what sleeps, and of what is about to, is put back to the bit") {
  for (const int before : {400, 1500}) {
    World world;
    add_pendulum(world);
    const BodyId rod = add_pendulum(world, vec(5, 0, 0));
    drag(world, 1.0);
    ConnectionDef def;
    def.ends = {{world.points[cases::point_of(world, rod, 1)].own, zero3()}, {{}, vec(5, -1.5, 0)}};
    def.solve = Solve::at_middle;
    add_connection(world, resting_law("spring", {{"stiffness", 1.0}, {"length", 0.5}}), def);
    steps(world, before);
    const Snapshot snapshot = take_snapshot(world);
    steps(world, 800);
    const std::uint64_t hash = state_hash(world);
    CHECK(sleepers(world) == 2);
    kick(world, rod, vec(1, 0, 0));
    steps(world, 10);
    CHECK(sleepers(world) == 1);
    restore(world, snapshot);
    steps(world, 800);
    CHECK(sleepers(world) == 2);
    CHECK(state_hash(world) == hash);
  }
}
