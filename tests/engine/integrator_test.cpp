// Integrators of the fourth order, and what they refuse.
#include "forces/integrator.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "choreography/hands.hpp"
#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/kepler.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

std::shared_ptr<const Law> library_law(const char* name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  return std::make_shared<Law>(make_library_law(name, arguments).front());
}

ConnectionId connect(World& world, End a, End b, std::shared_ptr<const Law> law, Solve solve = Solve::explicitly) {
  ConnectionDef def;
  def.ends = {a, b};
  def.solve = solve;
  return add_connection(world, std::move(law), def);
}

/// Two particles of ½ kg on an ellipse of unit half axis with e = 0.6 about each other: distance after one period from
/// where they were [m].
double kepler_error(Integrator integrator, int steps) {
  World world;
  world.settings.step = 2.0 * 3.14159265358979323846 / steps;
  const ParticleId a = cases::add_kepler_pair(world, 0.4, 2.0).a;
  set_integrator(world, integrator);
  for (int i = 0; i < steps; i++) step(world);
  CHECK(world.failure == "");
  return norm(position(world, cases::point_of(world, a)) - vec(0.2, 0, 0));
}

/// Distance of the end body of chain(10) from the reference at 1 s, [m].
double chain_error(double step_length) {
  World world;
  world.settings.step = step_length;
  const cases::Chain chain = cases::add_chain(world);
  set_integrator(world, Integrator::suzuki4);
  advance(world, 1.0);
  CHECK(world.failure == "");
  CHECK(world.worst.hinge_gap <= 1e-10);
  const reference::PlaneChain plane = reference::plane_chain(10);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 100), 9);
  return norm(world.motion_of(chain.bodies.back()).x - vec(position.x(), position.y(), 0));
}

/// Error of a free top's angular velocity at 20 s, [rad/s].
double top_error(Integrator integrator, double step_length) {
  World world;
  world.settings.step = step_length;
  const BodyId top = cases::add_top(world);
  set_integrator(world, integrator);
  advance(world, 20.0);
  const Vec3 spin = transposed_times(matrix(orientation(world, top)), angular_velocity(world.motion_of(top)));
  const Eigen::Vector3d expected = reference::top(20.0, 200);
  return norm(spin - vec(expected.x(), expected.y(), expected.z()));
}

}  // namespace

TEST_CASE("integrator: suzuki4 and rk4 are of fourth order on an ellipse") {
  const Integrator integrator = GENERATE(Integrator::suzuki4, Integrator::rk4);
  CAPTURE(name_of(integrator));
  const std::vector<double> steps = {1.0 / 400, 1.0 / 800, 1.0 / 1600};
  std::vector<double> errors;
  for (const int count : {400, 800, 1600}) errors.push_back(kepler_error(integrator, count));
  CAPTURE(errors);
  CHECK(exponent(steps, errors) == Approx(4.0).margin(0.4));
  CHECK(errors.back() <= 1e-6);
  CHECK(kepler_error(Integrator::verlet, 1600) >= 100.0 * errors.back());
}

TEST_CASE("integrator: suzuki4 moves a chain with an error of fourth order") {
  const std::vector<double> steps = {1.0 / 60, 1.0 / 120, 1.0 / 240};
  std::vector<double> errors;
  for (const double h : steps) errors.push_back(chain_error(h));
  CAPTURE(errors);
  CHECK(errors.front() <= 1.5e-6);
  CHECK(errors.back() <= 5e-9);
  CHECK(exponent(steps, errors) == Approx(4.0).margin(0.3));
}

TEST_CASE("integrator: a free top turns with an error of fourth order") {
  const Integrator integrator = GENERATE(Integrator::suzuki4, Integrator::rk4);
  CAPTURE(name_of(integrator));
  const std::vector<double> steps = {1.0 / 10, 1.0 / 20};
  const std::vector<double> errors = {top_error(integrator, steps[0]), top_error(integrator, steps[1])};
  CAPTURE(errors);
  CHECK(exponent(steps, errors) == Approx(4.0).margin(0.4));
  CHECK(errors.back() <= 1e-8);
}

TEST_CASE("integrator: suzuki4 keeps hinges and energy, and what is pulled past its length ends at least squares") {
  World world;
  world.settings.step = 1.0 / 120;
  cases::add_ring(world, 24);
  set_integrator(world, Integrator::suzuki4);
  const Watched course = watch(world, 3.0);
  CHECK(course.failure == "");
  CHECK(course.gap <= 1e-10);
  CHECK(course.energy_error() <= 1e-9);
  World pulled;
  const cases::Chain chain = cases::add_chain(pulled);
  FollowDef follow;
  follow.target = [](double time) { return vec(10 + 5 * std::fmin(time, 2 - time), 0, 0); };
  add_follow(pulled, chain.tails.back(), follow);
  set_integrator(pulled, Integrator::suzuki4);
  advance(pulled, 3.0);
  CHECK(pulled.failure == "");
  CHECK(pulled.stats.fallback_steps > 0);
  CHECK(pulled.error.hinge_gap <= 1e-7);
}

TEST_CASE("integrator: suzuki4 refuses what dissipates") {
  World world;
  ParticleDef def;
  const ParticleId a = add_particle(world, def);
  def.at = vec(1, 0, 0);
  const ParticleId b = add_particle(world, def);
  const ConnectionId damper = connect(world, {a}, {b}, library_law("damper", {{"damping", 1.0}}));
  CHECK_THROWS_WITH(set_integrator(world, Integrator::suzuki4),
                    Contains("suzuki4") && Contains("damper depends on velocities"));
  CHECK(world.settings.integrator == Integrator::verlet);
  remove(world, damper);
  set_integrator(world, Integrator::suzuki4);
  step(world);
  CHECK(world.failure == "");
  connect(world, {a}, {b}, library_law("damper", {{"damping", 1.0}}));
  step(world);
  CHECK_THAT(world.failure, Contains("suzuki4") && Contains("damper depends on velocities"));
}

TEST_CASE("integrator: a hand grabs nothing where suzuki4 moves things, and the scene goes on") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  set_integrator(world, Integrator::suzuki4);
  world.input.moves.push_back({0, vec(10, 1, 0), true});
  Command command;
  command.kind = Command::Kind::grab;
  command.point = chain.tails.back();
  world.input.commands.push_back(command);
  step(world);
  step(world);
  CHECK(world.failure == "");
  REQUIRE_FALSE(world.log.empty());
  CHECK_THAT(world.log.back().text, Contains("suzuki4"));
}

TEST_CASE("integrator: rk4 refuses constraints") {
  World world;
  cases::add_chain(world, {.links = 2, .pinned = false});
  CHECK_THROWS_WITH(set_integrator(world, Integrator::rk4), Contains("moves only what no constraint ties: there is"));
}

namespace {

/// Distance after 1 s from the closed form of a mass of 1 kg that falls at the end of a spring of 400 N/m without length,
/// solved with it [m].
double spring_error(double step_length) {
  World world;
  world.settings.step = step_length;
  ParticleDef def;
  def.at = vec(1, 0, 0);
  const ParticleId mass = add_particle(world, def);
  connect(world, {mass}, {{}, zero3()}, library_law("spring", {{"stiffness", 400.0}, {"length", 0.0}}),
          Solve::at_middle);
  set_integrator(world, Integrator::suzuki4);
  advance(world, 1.0);
  CHECK(world.failure == "");
  CHECK(world.articulates.size() == 1);
  const double c = std::cos(20.0);
  return norm(position(world, cases::point_of(world, mass)) - vec(c, -9.81 / 400.0 * (1.0 - c), 0));
}

}  // namespace

TEST_CASE("integrator: suzuki4 moves what is solved with a spring with an error of fourth order") {
  const std::vector<double> steps = {1.0 / 60, 1.0 / 120, 1.0 / 240};
  std::vector<double> errors;
  for (const double h : steps) errors.push_back(spring_error(h));
  CAPTURE(errors);
  CHECK(errors.back() <= 1e-5);
  CHECK(exponent(steps, errors) == Approx(4.0).margin(0.3));
}

TEST_CASE("integrator: suzuki4 refuses connections solved at the end of a step, and rk4 all solved ones") {
  World world;
  ParticleDef def;
  const ParticleId a = add_particle(world, def);
  def.at = vec(1, 0, 0);
  const ParticleId b = add_particle(world, def);
  const auto spring = library_law("spring", {{"stiffness", 10.0}, {"length", 1.0}});
  const ConnectionId end = connect(world, {a}, {b}, spring, Solve::at_end);
  CHECK_THROWS_WITH(set_integrator(world, Integrator::suzuki4), Contains("is solved at the end of the step"));
  remove(world, end);
  connect(world, {a}, {b}, spring, Solve::at_middle);
  CHECK_THROWS_WITH(set_integrator(world, Integrator::rk4), Contains("which is to be solved with what it ties"));
  set_integrator(world, Integrator::suzuki4);
  step(world);
  CHECK(world.failure == "");
}

TEST_CASE("integrator: connections too stiff for the step are solved under suzuki4, and not under rk4") {
  World world;
  world.settings.step = 1.0 / 60;
  ParticleDef def;
  const ParticleId a = add_particle(world, def);
  def.at = vec(1, 0, 0);
  const ConnectionId spring =
      connect(world, {a}, {add_particle(world, def)}, library_law("spring", {{"stiffness", 1e4}, {"length", 1.0}}));
  set_integrator(world, Integrator::rk4);
  step(world);
  CHECK(world.connections[spring].solve == Solve::explicitly);
  set_integrator(world, Integrator::suzuki4);
  step(world);
  CHECK(world.connections[spring].solve == Solve::at_middle);
  set_integrator(world, Integrator::rk4);
  step(world);
  CHECK(world.connections[spring].solve == Solve::explicitly);
  CHECK(world.articulates.empty());
  CHECK(world.failure == "");
}
