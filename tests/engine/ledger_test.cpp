// Every joule of kinetic energy has a line in the ledger, and the lines are worked out without each other.
#include "world/ledger.hpp"
#include "measure/ledger_closure.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "choreography/hands.hpp"
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/library.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/rods.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

double line(const World& world, Source source) { return world.ledger.given[static_cast<std::size_t>(source)]; }

/// ½ k (r - l)²
std::shared_ptr<const Law> ledger_spring(const char* name, double stiffness, double length) {
  Expressions g;
  const Expr stretch = g.subtract(g.square_root(g.input({Role::distance2, 0, 0, {}})), g.constant(length));
  LawDef def;
  def.name = name;
  const Expr energy = g.scale(g.multiply(stretch, stretch), 0.5 * stiffness);
  return std::make_shared<Law>(central_potential(def, g, energy));
}

void tie(World& world, std::shared_ptr<const Law> law, ParticleId a, ParticleId b) {
  ConnectionDef def;
  def.ends = {{a, zero3()}, {b, zero3()}};
  add_connection(world, std::move(law), def);
}

std::shared_ptr<const Law> ledger_law(const char* name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  return std::make_shared<Law>(make_library_law(name, arguments).front());
}

ParticleId mass_at(World& world, Vec3 at) {
  ParticleDef def;
  def.at = at;
  return add_particle(world, def);
}

}  // namespace

TEST_CASE("ledger: closes on chains, heavy chains and rings; what the projection took is nearly what was returned") {
  const int which = GENERATE(0, 1, 2);
  const double step = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(which, step);
  World world;
  world.settings.step = step;
  if (which == 0) cases::add_chain(world);
  if (which == 1) cases::add_heavy_chain(world, 10, 1e3);
  if (which == 2) cases::add_ring(world, 24);
  keep_ledger(world);
  advance(world, 3.0);
  CHECK(world.failure == "");
  CHECK(closure(world) <= 1e-10);
  CHECK(world.ledger.gravity == Approx(mechanical_energy(world).kinetic).epsilon(1e-6));
  CHECK(line(world, Source::projection) < 0.0);
  CHECK(line(world, Source::energy_return) == Approx(-line(world, Source::projection)).epsilon(1e-6));
  CHECK(std::fabs(truncation(world).at("gravity")) <= 1e-9 * world.ledger.gravity);
}

TEST_CASE("ledger: the lines of two springs and gravity on loose and tied things close, each with its own truncation") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3});
  const ParticleId a = mass_at(world, vec(3, -1, 0)), b = mass_at(world, vec(4, -1, 0.3));
  const ParticleId tail = world.points[chain.tails.back()].own;
  tie(world, ledger_spring("soft", 5, 0.5), tail, a);
  tie(world, ledger_spring("hard", 20, 0.9), a, b);
  keep_ledger(world);
  advance(world, 2.0);
  CHECK(world.failure == "");
  CHECK(closure(world) <= 1e-10);
  const double laws = world.ledger.kicks.at("soft") + world.ledger.kicks.at("hard");
  CHECK(laws == Approx(world.ledger.laws).epsilon(1e-12));
  const auto errors = truncation(world);
  const Energy now = energy(world);
  double sum = world.work + line(world, Source::projection) + line(world, Source::energy_return);
  for (const auto& [name, joules] : errors) sum += joules;
  CHECK(now.total() - world.start_energy == Approx(sum).margin(1e-9));
  CHECK(errors.at("hard") != 0.0);
}

TEST_CASE("ledger: closes with every integrator that moves hinges, and where accuracy divides steps") {
  struct Way {
    Integrator integrator;
    double accuracy;
  };
  const Way way = GENERATE(Way{Integrator::verlet, 1e-4}, Way{Integrator::implicit, 0.0},
                           Way{Integrator::implicit, 1e-5}, Way{Integrator::suzuki4, 0.0}, Way{Integrator::euler, 0.0});
  CAPTURE(name_of(way.integrator), way.accuracy);
  World world;
  cases::add_top(world);
  world.settings.gravity = vec(0, -9.81, 0);
  const cases::Chain chain = cases::add_chain(world, {.links = 4});
  const ParticleId a = mass_at(world, vec(4, -1, 0)), b = mass_at(world, vec(5, -1, 0.3));
  const ParticleId tail = world.points[chain.tails.back()].own;
  tie(world, ledger_spring("soft", 5, 0.5), tail, a);
  tie(world, ledger_spring("hard", 200, 0.9), a, b);
  set_integrator(world, way.integrator);
  if (way.accuracy > 0.0) set_accuracy(world, way.accuracy);
  keep_ledger(world);
  const double start = mechanical_energy(world).kinetic;
  advance(world, 2.0);
  CHECK(world.failure == "");
  CHECK(closure(world) <= 1e-10);
  CHECK((most_sub_steps(world).count > 1) == (way.accuracy > 0.0));
  CHECK((line(world, Source::integrator) != 0.0) == (way.integrator == Integrator::euler));
  CHECK(world.ledger.kicks.at("soft") + world.ledger.kicks.at("hard") == Approx(world.ledger.laws).epsilon(1e-9));
  double given = world.ledger.gravity + world.ledger.laws + world.work - line(world, Source::law);
  for (const Source source : {Source::projection, Source::energy_return, Source::integrator})
    given += line(world, source);
  CHECK(mechanical_energy(world).kinetic - start == Approx(given).epsilon(1e-9));
}

TEST_CASE("ledger: what rk4 gives by being inexact is of fourth order, and a line of its own") {
  std::vector<double> steps, lines;
  for (const double h : {0.05, 0.025, 0.0125}) {
    World world;
    world.settings.step = h;
    const ParticleId a = mass_at(world, zero3());
    tie(world, ledger_spring("spring", 10, 1), a, mass_at(world, vec(1.5, 0, 0)));
    cases::add_top(world);
    world.settings.gravity = vec(0, -9.81, 0);
    set_integrator(world, Integrator::rk4);
    keep_ledger(world);
    while (world.time < 2.0 - 0.5 * h) {
      push(world, test::point_of(world, a), vec(0, 3, 0));
      step(world);
    }
    CHECK(world.failure == "");
    CHECK(closure(world) <= 1e-10);
    CHECK(line(world, Source::event) != 0.0);
    steps.push_back(h);
    lines.push_back(std::fabs(line(world, Source::integrator)));
  }
  CAPTURE(lines);
  CHECK(exponent(steps, lines) == Approx(4.0).margin(0.5));
}

TEST_CASE("ledger: truncation of a spring falls with the square of the step") {
  double size[2];
  for (const int k : {0, 1}) {
    World world;
    world.settings.gravity = zero3();
    world.settings.step = 0.02 / (1 << k);
    tie(world, ledger_spring("spring", 10, 1), mass_at(world, zero3()), mass_at(world, vec(1.5, 0, 0)));
    keep_ledger(world);
    size[k] = 0.0;
    while (world.time < 2.0) {
      pantin::step(world);
      size[k] = std::fmax(size[k], std::fabs(truncation(world).at("spring")));
    }
    CHECK(closure(world) <= 1e-11);
  }
  CHECK(size[0] / size[1] == Approx(4.0).margin(0.5));
}

TEST_CASE("ledger: hands, pushes, kicks, emitted and removed things have lines, and it closes with them") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 5});
  const PointId loose = test::point_of(world, mass_at(world, vec(0, 3, 0)));
  keep_ledger(world);
  add_follow(world, chain.tails.back(), {.target = [](double t) { return vec(5 - t, 2 * t, 0); }, .max_force = 200});
  for (int i = 0; i < 240; i++) {
    if (i % 3 == 0 && i < 200) push(world, loose, vec(1, 20, 0));
    if (i == 100) kick(world, chain.bodies[1], vec(0, 1, 0.5));
    if (i == 150) mass_at(world, vec(7, 7, 7));
    if (i == 200) remove(world, world.points[loose].own);
    step(world);
  }
  CHECK(world.failure == "");
  CHECK(closure(world) <= 1e-10);
  CHECK(line(world, Source::hand) > 1.0);
  CHECK(std::fabs(line(world, Source::event)) > 1.0);
  CHECK(line(world, Source::edit) != 0.0);
  CHECK(line(world, Source::removal) != 0.0);
  double all = 0.0;
  for (const Source source :
       {Source::hand, Source::motor, Source::limit, Source::event, Source::edit, Source::emitter, Source::removal})
    all += line(world, source);
  CHECK(all == Approx(world.work).epsilon(1e-12));
}

TEST_CASE("ledger: a mass that changes is no error of the energy, of a free particle either") {
  for (const bool tied : {false, true}) {
    World world;
    const ParticleId particle = mass_at(world, vec(0, 3, 0));
    const PointId point = test::point_of(world, particle);
    if (tied) add_rod(world, point, vec(-2, 3, 0));
    keep_ledger(world);
    for (int i = 0; i < 200; i++) {
      if (i == 50 || i == 120) set_mass(world, point, i == 50 ? 2.5 : 0.5);
      step(world);
    }
    CHECK(world.worst.energy <= 1e-10);
    CHECK(closure(world) <= 1e-12);
    CHECK(line(world, Source::edit) != 0.0);
  }
}

TEST_CASE("ledger: fallback steps post what they take") {
  World world;
  const cases::Chain chain = cases::add_chain(world);
  keep_ledger(world);
  add_follow(world, chain.tails.back(), {.target = [](double t) { return vec(10 + 5 * t, 0, 0); }});
  advance(world, 1.0);
  CHECK(world.failure == "");
  CHECK(world.stats.fallback_steps > 0);
  CHECK(closure(world) <= 1e-8);
  CHECK(line(world, Source::fallback_step) != 0.0);
}

TEST_CASE("ledger: nothing but what comes from outside is posted while nobody asks, and asking changes no bit") {
  World plain, kept;
  for (World* world : {&plain, &kept}) {
    cases::add_chain(*world);
    const ParticleId a = mass_at(*world, vec(3, -1, 0)), b = mass_at(*world, vec(4, -1, 0.3));
    tie(*world, ledger_spring("spring", 5, 0.5), a, b);
  }
  keep_ledger(kept);
  advance(plain, 1.0);
  advance(kept, 1.0);
  CHECK(state_hash(plain) == state_hash(kept));
  CHECK(plain.ledger.gravity == 0.0);
  CHECK(line(plain, Source::projection) == 0.0);
}

TEST_CASE("ledger: motors and limits have lines of their own") {
  World world;
  const cases::Chain chain = cases::add_chain(world, {.links = 3});
  MotorDef motor;
  motor.axis = vec(0, 0, 1);
  motor.speed = 2.0;
  motor.max_torque = 40.0;
  add_motor(world, chain.bodies[1], chain.bodies[2], motor);
  keep_ledger(world);
  advance(world, 1.0);
  CHECK(world.failure == "");
  CHECK(closure(world) <= 1e-9);
  CHECK(line(world, Source::motor) > 0.1);
  CHECK(line(world, Source::hand) == 0.0);
}

// m x'' + c x' + k x = 0 from rest at A: x = A exp(-γ t) (cos ω t + γ/ω sin ω t), γ = c / 2m, ω² = k/m - γ².
TEST_CASE("ledger: what a damped oscillator loses is the line of dampers") {
  const double k = 100.0, c = 2.0, amplitude = 0.5, time = 1.3;
  const double gamma = 0.5 * c, omega = std::sqrt(k - gamma * gamma), decay = std::exp(-gamma * time);
  const double x = amplitude * decay * (std::cos(omega * time) + gamma / omega * std::sin(omega * time));
  const double v = -amplitude * decay * k / omega * std::sin(omega * time);
  const double lost = 0.5 * (v * v + k * x * x) - 0.5 * k * amplitude * amplitude;
  for (const Solve solve : {Solve::explicitly, Solve::at_middle}) {
    for (const bool on_a_body : {false, true}) {
      CAPTURE(static_cast<int>(solve), on_a_body);
      World world;
      world.settings.gravity = zero3();
      world.settings.step = 1.0 / 1000;
      ParticleId mass;
      if (on_a_body) {
        BodyDef def;
        def.at = vec(1.0 + amplitude, 0, 0);
        def.points.resize(1);
        def.points[0].mass = 1;
        mass = world.points[cases::point_of(world, add_body(world, def), 0)].own;
      } else {
        mass = mass_at(world, vec(1.0 + amplitude, 0, 0));
      }
      ConnectionDef def;
      def.ends = {{mass, zero3()}, {{}, zero3()}};
      def.solve = solve;
      add_connection(world, ledger_law("spring", {{"stiffness", k}, {"length", 1.0}}), def);
      add_connection(world, ledger_law("damper", {{"damping", c}}), def);
      keep_ledger(world);
      advance(world, time);
      CHECK(world.failure == "");
      CHECK(position(world, mass)[0] - 1.0 == Approx(x).margin(1e-4));
      CHECK(line(world, Source::damper) == Approx(lost).epsilon(1e-4));
      CHECK(world.nonconservative_work == 0.0);
      CHECK(closure(world) <= 1e-10);
    }
  }
}

TEST_CASE("ledger: what a spring swallows that is solved at the end of the step is the line of dampers") {
  World world;
  world.settings.gravity = zero3();
  const ParticleId mass = mass_at(world, vec(1.5, 0, 0));
  ConnectionDef def;
  def.ends = {{mass, zero3()}, {{}, zero3()}};
  def.solve = Solve::at_end;
  add_connection(world, ledger_spring("spring", 100, 1.0), def);
  keep_ledger(world);
  advance(world, 2.0);
  CHECK(line(world, Source::damper) < -0.5);
  CHECK(energy(world).total() - world.start_energy == Approx(line(world, Source::damper)).epsilon(1e-9));
  CHECK(closure(world) <= 1e-10);
}

namespace {

/// Turns the first link of a pinned chain at 2 rad/s.
void turn_chain(World& world, int links) {
  const cases::Chain chain = cases::add_chain(world, {.links = links});
  MotorDef motor;
  motor.axis = vec(0, 0, 1);
  motor.speed = 2.0;
  add_motor(world, chain.bodies[0], {}, motor);
}

}  // namespace

TEST_CASE("ledger: what a motor gives is the motor's, with halves of projections carried over and by Euler's steps") {
  const Integrator integrator = GENERATE(Integrator::verlet, Integrator::euler);
  CAPTURE(name_of(integrator));
  World world;
  world.settings.step = integrator == Integrator::euler ? 1.0 / 4000 : 1.0 / 240;
  turn_chain(world, 2);
  set_integrator(world, integrator);
  keep_ledger(world);
  advance(world, 0.1);  // to its speed
  const double start = energy(world).total(), given = line(world, Source::motor);
  advance(world, 0.5);
  const double rise = energy(world).total() - start;
  CHECK(rise > 2.0);
  CHECK(line(world, Source::motor) - given == Approx(rise).epsilon(integrator == Integrator::euler ? 2e-2 : 1e-3));
  CHECK(line(world, Source::hand) == 0.0);
  CHECK(closure(world) <= 1e-10);
}

TEST_CASE("ledger: what a twist gives to what is tied is told, by Euler's steps too") {
  const Integrator integrator = GENERATE(Integrator::verlet, Integrator::euler);
  CAPTURE(name_of(integrator));
  World world;
  world.settings.step = 1.0 / 1000;
  world.settings.gravity = zero3();
  const BodyId link = cases::add_chain(world, {.links = 1}).bodies[0];
  set_integrator(world, integrator);
  keep_ledger(world);
  for (int i = 0; i < 500; i++) {
    twist(world, link, vec(0, 0, 1));
    step(world);
  }
  const double given = energy(world).kinetic;
  CHECK(given > 0.3);
  CHECK(line(world, Source::hand) == Approx(given).epsilon(integrator == Integrator::euler ? 1e-2 : 1e-9));
  CHECK(closure(world) <= 1e-10);
}

TEST_CASE("ledger: in fallback steps too a motor's work is not a hand's") {
  World world;
  turn_chain(world, 1);
  add_nail(world, cases::point_of(world, world.bodies.ids()[0], 1));
  keep_ledger(world);
  advance(world, 0.5);
  CHECK(world.failure == "");
  CHECK(world.stats.fallback_steps > 0);
  CHECK(line(world, Source::hand) == Approx(0.0).margin(1e-9));
  CHECK(closure(world) <= 1e-10);
}
