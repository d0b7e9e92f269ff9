// Laws at work in a world: on free particles, on bodies and hinges, through edits and failures.
#include "forces/forces.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "edit/edit.hpp"
#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

constexpr double pi = 3.14159265358979323846;

/// ½ k (r - l)², with the parameters "stiffness" and "length".
std::shared_ptr<const Law> spring(double stiffness, double length) {
  Expressions g;
  const Expr r = g.square_root(g.input({Role::distance2, 0, 0, {}}));
  const Expr stretch = g.subtract(r, g.input({Role::parameter, 0, 0, "length"}));
  const Expr k = g.input({Role::parameter, 0, 0, "stiffness"});
  LawDef def;
  def.name = "spring";
  def.parameters = {{"stiffness", stiffness, "N/m"}, {"length", length, "m"}};
  const Expr energy = g.scale(g.multiply(k, g.multiply(stretch, stretch)), 0.5);
  return std::make_shared<Law>(central_potential(def, g, energy));
}

/// -G m m / r
std::shared_ptr<const Law> gravitation(double constant) {
  Expressions g;
  const Expr masses = g.multiply(g.input({Role::attribute, 0, 0, "mass"}), g.input({Role::attribute, 1, 0, "mass"}));
  const Expr energy = g.scale(g.multiply(masses, g.power(g.input({Role::distance2, 0, 0, {}}), -0.5)), -constant);
  LawDef def;
  def.name = "gravitation";
  return std::make_shared<Law>(central_potential(def, g, energy));
}

/// -c v
std::shared_ptr<const Law> drag(double c) {
  Expressions g;
  std::vector<Expr> force;
  for (std::uint8_t k = 0; k < 3; k++) force.push_back(g.scale(g.input({Role::velocity, 0, k, {}}), -c));
  LawDef def;
  def.name = "drag";
  return std::make_shared<Law>(point_force(def, g, force));
}

ParticleId particle(World& world, Vec3 at, Vec3 velocity = zero3(), double mass = 1.0) {
  ParticleDef def;
  def.at = at;
  def.velocity = velocity;
  def.mass = mass;
  return add_particle(world, def);
}

ConnectionId connect(World& world, std::shared_ptr<const Law> law, std::vector<End> ends) {
  ConnectionDef def;
  def.ends = std::move(ends);
  return add_connection(world, std::move(law), def);
}

World& weightless(World& world, double step) {
  world.settings.gravity = zero3();
  world.settings.step = step;
  return world;
}

}  // namespace

TEST_CASE("forces: a spring swings as its closed form says, at second order") {
  std::vector<double> steps, errors;
  for (double h : {1.0 / 100, 1.0 / 200, 1.0 / 400}) {
    World world;
    weightless(world, h);
    const ParticleId a = particle(world, vec(-0.75, 0, 0)), b = particle(world, vec(0.75, 0, 0));
    connect(world, spring(8, 1), {{a}, {b}});
    advance(world, 1.0);
    const double distance = norm(position(world, b) - position(world, a));
    steps.push_back(h);
    errors.push_back(std::fabs(distance - (1 + 0.5 * std::cos(4.0))));
    CHECK(norm(momentum(world, everything(world))) <= 1e-14);
  }
  CHECK(errors.back() <= 1e-4);
  CHECK(exponent(steps, errors) == Approx(2.0).margin(0.05));
}

TEST_CASE("forces: a Kepler orbit of eccentricity 0.6 keeps its energy for a hundred turns, to second order") {
  std::vector<double> steps, errors;
  for (int n : {1000, 2000}) {
    World world;
    weightless(world, 2 * pi / n);
    FamilyDef def;
    def.name = "planets";
    const FamilyId family = add_family(world, def);
    const ParticleId sun = particle(world, zero3(), zero3(), 1e6),
                     planet = particle(world, vec(0.4, 0, 0), vec(0, 2, 0));
    for (ParticleId p : {sun, planet}) set_family(world, p, family);
    add_interaction(world, gravitation(1e-6), family, family);
    double worst = 0.0, late = 0.0;
    const double first = energy(world).total();
    for (int i = 0; i < 100 * n; i++) {
      step(world);
      if (i % 97 != 0) continue;
      const double wrong = std::fabs(energy(world).total() - first);
      (i < 50 * n ? worst : late) = std::fmax(i < 50 * n ? worst : late, wrong);
    }
    CHECK(late <= 1.05 * worst);
    steps.push_back(world.settings.step);
    errors.push_back(worst);
  }
  CHECK(errors[0] <= 2e-3);
  CHECK(exponent(steps, errors) == Approx(2.0).margin(0.1));
}

TEST_CASE("forces: on points of bodies they turn the bodies, and keep both momenta and the energy") {
  World world;
  weightless(world, 1.0 / 1000);
  BodyDef left, right;
  right.at = vec(3, 0.5, 0.2);
  const BodyId a = cases::add_rod_body(world, 1, 1, left), b = cases::add_rod_body(world, 2, 1, right);
  connect(world, spring(20, 1.5),
          {{world.points[cases::point_of(world, a, 1)].own}, {world.points[cases::point_of(world, b, 0)].own}});
  set_spin(world, a, vec(0.3, 1, 0.5));
  const Vec3 p = momentum(world, everything(world)), l = angular_momentum(world, everything(world));
  const double first = energy(world).total();
  advance(world, 3.0);
  CHECK(norm(momentum(world, everything(world)) - p) <= 1e-12);
  CHECK(norm(angular_momentum(world, everything(world)) - l) <= 1e-12);
  CHECK(energy(world).total() == Approx(first).epsilon(1e-4));
  CHECK(world.worst.energy <= 1e-4);
}

TEST_CASE("forces: a spring on a hinge pulls the bodies that it joins") {
  World world;
  world.settings.step = 1.0 / 1000;
  const cases::Chain chain = cases::add_chain(world, {.links = 4});
  ConnectionDef def;
  def.ends = {{chain.hinges[1]}, {ParticleId{}, vec(2, 3, 0)}};
  add_connection(world, spring(30, 1), def);
  const Watched course = watch(world, 2.0);
  CHECK(course.gap <= 1e-10);
  CHECK(world.worst.energy <= 1e-3);
  CHECK(position(world, chain.hinges[1])[1] > -1.5);
}

TEST_CASE("forces: a linear drag stops a particle as its closed form says, and a strong one is stable") {
  for (double c : {0.5, 5.0}) {
    World world;
    weightless(world, 1.0 / 240);
    const ParticleId p = particle(world, zero3(), vec(1, 2, 3));
    add_field(world, drag(c), {});
    advance(world, 1.0);
    CHECK(norm(velocity(world, p) - vec(1, 2, 3) * std::exp(-c)) <= 2e-4);
  }
  World world;
  weightless(world, 1.0 / 240);
  const ParticleId p = particle(world, zero3(), vec(1, 2, 3));
  add_field(world, drag(1e5), {});
  advance(world, 1.0);
  CHECK(norm(velocity(world, p)) <= 4.0);
}

TEST_CASE("forces: edits are work from outside, and leave the balance of energy true") {
  World world;
  world.settings.step = 1.0 / 1000;
  const ParticleId a = particle(world, vec(-1, 0, 0)), b = particle(world, vec(1, 0, 0));
  const auto law = spring(50, 1);
  const ConnectionId first = connect(world, law, {{a}, {b}});
  advance(world, 0.2);
  const ConnectionId second = connect(world, law, {{a}, {ParticleId{}, vec(0, 1, 0)}});
  advance(world, 0.4);
  set_position(world, cases::point_of(world, b), vec(2, 0, 0));
  set_parameter(world, first, 0, 80);
  advance(world, 0.6);
  set_enabled(world, second, false);
  advance(world, 0.7);
  set_enabled(world, second, true);
  remove(world, first);
  advance(world, 0.8);
  remove(world, a);
  CHECK_FALSE(world.connections.alive(second));
  advance(world, 1.0);
  CHECK(world.worst.energy <= 1e-3);
}

TEST_CASE("forces: a connection breaks under its load, is told, and pulls no more") {
  World world;
  weightless(world, 1.0 / 240);
  const ParticleId a = particle(world, zero3()), b = particle(world, vec(1, 0, 0), vec(10, 0, 0));
  ConnectionDef def;
  def.ends = {{a}, {b}};
  def.max_force = 30;
  const ConnectionId c = add_connection(world, spring(40, 1), def);
  int told = 0;
  world.behaviours = [&] {
    for (const Notice& n : world.notices)
      if (n.kind == Notice::Kind::broke && n.thing == AnyId(c) && n.force > 30) told++;
  };
  advance(world, 1.0);
  CHECK(told == 1);
  CHECK_FALSE(world.connections.alive(c));
  CHECK(velocity(world, b)[0] > 5.0);
  REQUIRE(world.breaks.size() == 1);
  CHECK(norm(world.breaks[0].to - world.breaks[0].from) == Approx(1 + 30.0 / 40).margin(0.1));
  CHECK(world.breaks[0].time > 0.0);
  CHECK(world.breaks[0].time < 1.0);
}

TEST_CASE("forces: a cutoff that comes of a parameter follows it") {
  World world;
  weightless(world, 1.0 / 240);
  FamilyDef def;
  def.name = "atoms";
  const FamilyId family = add_family(world, def);
  const auto atom = [&](Vec3 at) {
    ParticleDef made;
    made.at = at;
    made.family = family;
    add_particle(world, made);
  };
  atom(zero3());
  atom(vec(3, 0, 0));
  LawArguments arguments;
  arguments.numbers = {{"epsilon", 1.0}, {"sigma", 1.0}};
  arguments.shift = false;
  const auto law = std::make_shared<Law>(make_library_law("lennard_jones", arguments)[0]);
  const InteractionId id = add_interaction(world, law, family, family);
  step(world);
  CHECK(*law_energy(world, id) == 0.0);
  set_parameter(world, id, 1, 2.0);
  step(world);
  const double s6 = std::pow(2.0 / 3.0, 6);
  CHECK(*law_energy(world, id) == Approx(4 * (s6 * s6 - s6)).epsilon(1e-3));
  CHECK(world.interactions[id].law->cutoff == 5.0);
  CHECK_THROWS_WITH(set_parameter(world, id, 1, -2.0), Catch::Contains("sigma must be > 0 m, got -2"));
  CHECK(world.interactions[id].parameters[1] == 2.0);
}

TEST_CASE("forces: pairs of one body and pairs in one hinge do not interact") {
  World world;
  weightless(world, 1.0 / 240);
  FamilyDef def;
  def.name = "stars";
  const FamilyId family = add_family(world, def);
  BodyDef rod;
  rod.points.resize(2);
  for (int i = 0; i < 2; i++) {
    rod.points[static_cast<std::size_t>(i)].at = vec(i, 0, 0);
    rod.points[static_cast<std::size_t>(i)].mass = 1;
    rod.points[static_cast<std::size_t>(i)].family = family;
  }
  const BodyId a = add_body(world, rod);
  rod.at = vec(1, 0, 0);
  const BodyId b = add_body(world, rod);
  const PointId tips[] = {world.bodies[a].points[1], world.bodies[b].points[0]};
  add_hinge(world, tips);
  const InteractionId id = add_interaction(world, gravitation(1), family, family);
  // Only the outer two interact: at a distance of 2, with masses 1 and 1. The hinge shares a body with either.
  CHECK(law_energy(world, id).value() == Approx(-0.5));
}

TEST_CASE("forces: a force that is not a number stops the world in its last good state, and names its law") {
  World world;
  weightless(world, 1.0 / 240);
  Expressions g;
  const Expr bad = g.square_root(g.subtract(g.square_root(g.input({Role::distance2, 0, 0, {}})), g.constant(1)));
  LawDef def;
  def.name = "scene.lua:7";
  const auto law = std::make_shared<Law>(central_tension(def, g, bad));
  const ParticleId a = particle(world, zero3()), b = particle(world, vec(1.5, 0, 0), vec(-1, 0, 0));
  connect(world, law, {{a}, {b}});
  advance(world, 2.0);
  CHECK(world.failure.find("scene.lua:7: the force between particle") == 0);
  CHECK(std::isfinite(position(world, b)[0]));
  CHECK(norm(position(world, b) - position(world, a)) > 1.0);
}

TEST_CASE("forces: a law that reads what a particle has not is refused by name") {
  World world;
  Expressions g;
  std::vector<Expr> force(3, g.input({Role::attribute, 0, 0, "charge"}));
  LawDef def;
  def.name = "scene.lua:9";
  const auto law = std::make_shared<Law>(point_force(def, g, force));
  particle(world, zero3());
  add_field(world, law, {});
  step(world);
  CHECK(world.failure.find("scene.lua:9: it reads 'charge', which particle") == 0);
}

TEST_CASE("forces: the present ones are told at any time, before the first step too, and change nothing") {
  World world;
  world.settings.gravity = zero3();
  ParticleDef def;
  const ParticleId a = add_particle(world, def);
  def.at = vec(0.5, 0, 0);
  const ParticleId b = add_particle(world, def);
  def.at = vec(5, 0, 0);
  const ParticleId alone = add_particle(world, def);
  ConnectionDef tie;
  tie.ends = {{a}, {b}};
  add_connection(world, spring(8.0, 1.0), tie);
  const auto check = [&](double length) {
    const std::uint64_t before = state_hash(world);
    const PresentForces now = present_forces(world);
    CHECK(now.energy == Approx(4.0 * (length - 1.0) * (length - 1.0)));
    CHECK(now.on[a.slot - 1][0] == Approx(8.0 * (length - 1.0)));
    CHECK(same(now.on[b.slot - 1], now.on[a.slot - 1] * -1.0));
    CHECK(same(now.on[alone.slot - 1], zero3()));
    CHECK(state_hash(world) == before);
  };
  check(0.5);
  for (int i = 0; i < 10; i++) step(world);
  check(norm(position(world, b) - position(world, a)));
}

TEST_CASE("forces: no law, an empty one, one of another kind and a parameter that there is not are refused") {
  using Catch::Contains;
  World world;
  FamilyDef stars;
  stars.name = "stars";
  const FamilyId family = add_family(world, stars);
  std::vector<ParticleId> ids;
  for (int i = 0; i < 3; i++) {
    ParticleDef def;
    def.at = vec(i, 0.1 * i, 0);
    def.family = family;
    ids.push_back(add_particle(world, def));
  }
  const auto law_of = [](const char* name, const std::map<std::string, double>& numbers) {
    LawArguments arguments;
    arguments.numbers = numbers;
    return std::make_shared<const Law>(make_library_law(name, arguments)[0]);
  };
  const auto pair = law_of("lennard_jones", {{"epsilon", 1.0}, {"sigma", 1.0}}),
             angle = law_of("angle", {{"stiffness", 1.0}, {"angle", 2.0}});
  auto beyond = std::make_shared<Law>(*pair);
  beyond->force = {12345};
  auto crowd = std::make_shared<Law>(*angle);
  crowd->count = 99;
  ConnectionDef tie;
  tie.ends = {{ids[0], zero3()}, {ids[1], zero3()}};
  const InteractionId interaction = add_interaction(world, pair, family, family);
  step(world);
  const std::uint64_t before = state_hash(world);
  const std::vector<std::shared_ptr<const Law>> wrong = {nullptr, std::make_shared<Law>(), beyond, crowd};
  for (const auto& law : wrong) {
    CHECK_THROWS_AS(add_interaction(world, law, family, family), Error);
    CHECK_THROWS_AS(add_connection(world, law, tie), Error);
    CHECK_THROWS_AS(add_field(world, law, {}), Error);
    CHECK_THROWS_AS(replace_law(world, pair, law), Error);
    CHECK_THROWS_AS(replace_law(world, law, pair), Error);
  }
  CHECK_THROWS_WITH(add_field(world, nullptr, {}), "field: a law is needed, got none");
  CHECK_THROWS_WITH(replace_law(world, pair, angle), Contains("a pair law of 2 particles, got a many law of 3 for it"));
  CHECK_THROWS_WITH(replace_law(world, pair, gravitation(1.0)),
                    Contains("the law has 2 parameters, got one of 0 for it"));
  CHECK_THROWS_WITH(set_parameter(world, interaction, 99, 1.0), Contains("got the index 99"));
  CHECK_THROWS_AS(set_parameter(world, interaction, 0, -std::numeric_limits<double>::infinity()), Error);
  CHECK_THROWS_AS(set_parameter(world, InteractionId{}, 0, 1.0), Error);
  CHECK_THROWS_AS(set_enabled(world, ForceElementId(InteractionId{}), false), Error);
  CHECK_FALSE(world.force_elements_changed);
  CHECK(state_hash(world) == before);
  CHECK_NOTHROW(replace_law(world, pair, spring(1.0, 1.0)));
}
