// Connections solved with what they tie: any stiffness at any step.
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/endure.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

const Input distance_squared{Role::distance2, 0, 0, {}};

/// ½ k (r - length)²; without a length ½ k r².
std::shared_ptr<const Law> elastic(double k, double length = 0.0) {
  Expressions g;
  const Expr r2 = g.input(distance_squared);
  const Expr stretch = length > 0.0 ? g.add(g.square_root(r2), g.constant(-length)) : g.square_root(r2);
  const Expr energy = g.scale(g.multiply(stretch, stretch), 0.5 * k);
  LawDef def;
  def.name = "elastic";
  return std::make_shared<Law>(central_potential(def, g, energy));
}

/// c times the rate of the distance.
std::shared_ptr<const Law> viscous(double c) {
  Expressions g;
  const Expr tension = g.scale(rate_of_distance(g), c);
  LawDef def;
  def.name = "viscous";
  return std::make_shared<Law>(central_tension(def, g, tension));
}

ParticleId ball(World& world, Vec3 at, double mass, Vec3 velocity = zero3()) {
  ParticleDef def;
  def.at = at;
  def.mass = mass;
  def.velocity = velocity;
  return add_particle(world, def);
}

ConnectionId tie(World& world, std::shared_ptr<const Law> law, std::vector<End> ends, Solve solve = Solve::at_middle) {
  ConnectionDef def;
  def.ends = std::move(ends);
  def.solve = solve;
  return add_connection(world, std::move(law), def);
}

/// Ten links from horizontal, nailed at one end; every second joint is a spring of no length.
void hang_on_springs(World& world, double stiffness) {
  world.settings.step = 1.0 / 60.0;
  world.settings.energy_return = false;
  const auto law = elastic(stiffness);
  PointId last;
  for (int i = 0; i < 10; i++) {
    BodyDef def;
    def.at = vec(i + 0.5, 0, 0);
    const BodyId body = cases::add_rod_body(world, 1.0, 1.0, def);
    const PointId first = cases::point_of(world, body, 0);
    if (i == 0)
      add_nail(world, first);
    else if (i % 2 == 0)
      add_hinge(world, std::vector<PointId>{last, first});
    else
      tie(world, law, {{world.points[last].own}, {world.points[first].own}});
    last = cases::point_of(world, body, 1);
  }
}

}  // namespace

TEST_CASE("stiff: springs from 1e2 to 1e12 N/m in every second hinge keep their energy at 1/60 s") {
  for (double k = 1e2; k <= 1e12; k *= 100) {
    CAPTURE(k);
    World world;
    hang_on_springs(world, k);
    world.settings.energy_return = true;
    double worst = 0.0;
    for (int i = 0; i < 300; i++) {
      step(world);
      worst = std::fmax(worst, world.error.energy);
    }
    CHECK(world.failure.empty());
    CHECK(world.stats.fallback_steps == 0);
    CHECK(worst <= 3e-9);
  }
}

TEST_CASE("stiff: they do at every step length") {
  for (double k = 1e2; k <= 1e12; k *= 1e5)
    endure_at(
        step_lengths, text("I springs of ", k, " N/m"), 1.0, 1.0,
        [k](World& world) {
          const double step = world.settings.step;
          hang_on_springs(world, k);
          world.settings.step = step;
          world.settings.energy_return = true;
          return Action{};
        },
        [](const World&, const Endured& run) {
          CHECK(run.energy <= 3e-9);
          CHECK(run.fallbacks == 0);
        });
}

TEST_CASE("stiff: a spring swings as its closed form says, at second order") {
  std::vector<double> steps, errors;
  for (double h : {1.0 / 100, 1.0 / 200, 1.0 / 400}) {
    World world;
    world.settings.gravity = zero3();
    world.settings.step = h;
    const ParticleId a = ball(world, vec(-0.75, 0, 0), 1), b = ball(world, vec(0.75, 0, 0), 1);
    tie(world, elastic(8, 1), {{a}, {b}});
    advance(world, 1.0);
    steps.push_back(h);
    errors.push_back(std::fabs(norm(position(world, b) - position(world, a)) - (1 + 0.5 * std::cos(4.0))));
    CHECK(norm(momentum(world, everything(world))) <= 1e-13);
  }
  CHECK(errors.back() <= 1e-4);
  CHECK(exponent(steps, errors) == Approx(2.0).margin(0.05));
}

TEST_CASE("stiff: a spring a million times too stiff for the step keeps energy and its tension carries the load") {
  World world;
  world.settings.step = 1.0 / 60.0;
  const ParticleId b = ball(world, vec(0, -1, 0), 2);
  const ConnectionId spring = tie(world, elastic(1e10, 1), {{{}, zero3()}, {b}});
  const double first = energy(world).total();
  for (int i = 0; i < 600; i++) step(world);
  CHECK(energy(world).total() == Approx(first).margin(1e-9));
  CHECK(position(world, b)[1] == Approx(-1).margin(1e-7));
  CHECK(std::fabs(tension(world, spring)) <= 2.01 * 2 * 9.81);
}

TEST_CASE("stiff: a damper that the step cannot follow brings both ends to one velocity, and what it takes is told") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / 60.0;
  const ParticleId a = ball(world, vec(0, 0, 0), 1, vec(-3, 0, 0)), b = ball(world, vec(1, 0, 0), 2, vec(3, 0, 0));
  tie(world, viscous(1e6), {{a}, {b}}, Solve::at_end);
  for (int i = 0; i < 60; i++) step(world);
  CHECK(velocity(world, a)[0] == Approx(1).margin(1e-4));
  CHECK(velocity(world, b)[0] == Approx(1).margin(1e-4));
  CHECK(world.ledger.given[static_cast<std::size_t>(Source::damper)] == Approx(-12).margin(1e-6));
  CHECK(world.error.energy <= 1e-9);
}

TEST_CASE("stiff: solved dissipatively a spring comes to rest, and never gains energy") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / 60.0;
  const ParticleId a = ball(world, vec(0, 0, 0), 1), b = ball(world, vec(1.2, 0, 0), 1);
  tie(world, elastic(2000, 1), {{a}, {b}}, Solve::at_end);
  double last = energy(world).total();
  for (int i = 0; i < 600; i++) {
    step(world);
    const double now = energy(world).total();
    CHECK(now <= last * (1 + 1e-9) + 1e-12);
    last = now;
  }
  CHECK(norm(position(world, b) - position(world, a)) == Approx(1).margin(1e-3));
  CHECK(world.error.energy <= 1e-9);
}

TEST_CASE("stiff: a soft spring moves a chain as the explicit one does, to second order") {
  std::vector<double> steps, differences;
  for (double h : {1.0 / 240, 1.0 / 480, 1.0 / 960}) {
    Vec3 end[2];
    for (int k = 0; k < 2; k++) {
      World world;
      world.settings.step = h;
      world.settings.energy_return = false;
      cases::ChainDef def;
      def.links = 3;
      const PointId tip = cases::add_chain(world, def).tails.back();
      const ConnectionId id = tie(world, elastic(0.5, 1), {{{}, vec(1, -1, 1)}, {world.points[tip].own}},
                                  k == 0 ? Solve::explicitly : Solve::at_middle);
      advance(world, 0.5);
      CHECK((world.connections[id].solve == Solve::explicitly) == (k == 0));
      end[k] = position(world, tip);
    }
    steps.push_back(h);
    differences.push_back(norm(end[1] - end[0]));
  }
  CHECK(differences.back() <= 1e-4);
  CHECK(exponent(steps, differences) == Approx(2.0).margin(0.2));
}

TEST_CASE("stiff: explicit springs that the step cannot follow are solved by themselves, which is told once") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1.0 / 60.0;
  const auto stiff = elastic(1e7, 1), soft = elastic(1, 1);
  std::vector<ParticleId> row;
  for (int i = 0; i < 20; i++) row.push_back(ball(world, vec(i * 1.001, 0, 0), 1));
  for (std::size_t i = 1; i < row.size(); i++) tie(world, stiff, {{row[i - 1]}, {row[i]}}, Solve::explicitly);
  const ParticleId far = ball(world, vec(0, 5, 0), 1), near = ball(world, vec(0, 6.2, 0), 1);
  const ConnectionId slack = tie(world, soft, {{far}, {near}}, Solve::explicitly);
  const double first = energy(world).total();
  for (int i = 0; i < 300; i++) step(world);
  CHECK(energy(world).total() == Approx(first).epsilon(1e-7));
  CHECK(world.articulates.size() == 1);
  CHECK(world.connections[slack].solve == Solve::explicitly);
  CHECK(std::count_if(world.log.begin(), world.log.end(), [](const LogLine& line) {
          return line.text.find("are solved with what they tie") != std::string::npos;
        }) == 1);
}

TEST_CASE("stiff: with the implicit integrator all connections are solved, and freed when it changes back") {
  World world;
  const ParticleId a = ball(world, vec(0, 0, 0), 1), b = ball(world, vec(1, 0, 0), 1);
  tie(world, elastic(10, 1), {{a}, {b}}, Solve::explicitly);
  set_integrator(world, Integrator::implicit);
  step(world);
  CHECK(world.articulates.size() == 1);
  set_integrator(world, Integrator::verlet);
  step(world);
  CHECK(world.articulates.empty());
}

TEST_CASE("stiff: a solved connection breaks at its load, can be disabled and removed") {
  World world;
  world.settings.step = 1.0 / 60.0;
  const auto law = elastic(1e8, 1);
  const ParticleId a = ball(world, vec(0, -1, 0), 1), b = ball(world, vec(5, -1, 0), 100);
  ConnectionDef def;
  def.solve = Solve::at_middle;
  def.max_force = 500;
  def.ends = {{{}, zero3()}, {a}};
  const ConnectionId light = add_connection(world, law, def);
  def.ends = {{{}, vec(5, 0, 0)}, {b}};
  const ConnectionId heavy = add_connection(world, law, def);
  step(world);
  step(world);
  CHECK(world.connections.alive(light));
  CHECK_FALSE(world.connections.alive(heavy));
  set_enabled(world, light, false);
  advance(world, 1.0);
  CHECK(position(world, a)[1] < -4);
  set_breaks_at(world, light, infinity, infinity);
  set_enabled(world, light, true);
  step(world);
  CHECK(world.articulates.size() == 1);
  remove(world, light);
  step(world);
  CHECK(world.articulates.empty());
}

TEST_CASE("stiff: soft springs that hang on a nail stay explicit, and go back to it when the integrator does") {
  World world;
  const auto law = elastic(2000, 0.1);
  std::vector<ParticleId> row;
  std::vector<ConnectionId> springs;
  for (int i = 0; i < 10; i++) row.push_back(ball(world, vec(0.1 * i, 0, 0), 1));
  for (std::size_t i = 1; i < row.size(); i++)
    springs.push_back(tie(world, law, {{row[i - 1]}, {row[i]}}, Solve::explicitly));
  add_nail(world, cases::point_of(world, row[0]));
  const auto solved = [&] {
    return std::count_if(springs.begin(), springs.end(),
                         [&](ConnectionId id) { return world.connections[id].solve != Solve::explicitly; });
  };
  for (int i = 0; i < 100; i++) step(world);
  CHECK(solved() == 0);
  set_integrator(world, Integrator::implicit);
  step(world);
  CHECK(solved() == 9);
  set_integrator(world, Integrator::verlet);
  for (int i = 0; i < 100; i++) step(world);
  CHECK(solved() == 0);
  CHECK(world.worst.energy <= 1e-3);
}

TEST_CASE("stiff: what is too stiff stays solved when the integrator changes back") {
  World world;
  const ParticleId a = ball(world, vec(0, 0, 0), 1), b = ball(world, vec(1, 0, 0), 1);
  const ConnectionId spring = tie(world, elastic(1e7, 1), {{a}, {b}}, Solve::explicitly);
  add_nail(world, cases::point_of(world, a));
  set_integrator(world, Integrator::implicit);
  for (int i = 0; i < 10; i++) step(world);
  set_integrator(world, Integrator::verlet);
  for (int i = 0; i < 100; i++) step(world);
  CHECK(world.connections[spring].solve == Solve::at_middle);
  CHECK(world.worst.energy <= 1e-8);
}

TEST_CASE("stiff: constraints of the same articulate may break") {
  World world;
  world.settings.step = 1.0 / 60.0;
  const ParticleId a = ball(world, vec(0, -1, 0), 1), b = ball(world, vec(0, -2, 0), 1);
  const ConstraintId rod = add_rod(world, cases::point_of(world, a), zero3());
  tie(world, elastic(1e7, 1), {{a}, {b}});
  set_breaks_at(world, rod, Breaking{1e4});
  for (int i = 0; i < 60; i++) step(world);
  CHECK(world.constraints.alive(rod));
  set_breaks_at(world, rod, Breaking{15});
  step(world);
  CHECK_FALSE(world.constraints.alive(rod));
}

TEST_CASE("stiff: a law of three cannot be solved, nor one in a periodic box") {
  World world;
  const ParticleId a = ball(world, vec(0, 0, 0), 1), b = ball(world, vec(1, 0, 0), 1);
  set_box(world, vec(4, 4, 4));
  CHECK_THROWS_WITH(tie(world, elastic(1, 1), {{a}, {b}}), Catch::Contains("periodic box"));
}
