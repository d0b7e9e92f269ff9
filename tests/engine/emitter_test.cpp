// Emitters: how many particles, when, where, and what they bring with them.
#include "edit/emitter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "forces/curves.hpp"
#include "forces/forces.hpp"
#include "laws/curve.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/allocations.hpp"
#include "support/cases.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

EmitterDef fountain(double rate, double lifetime) {
  EmitterDef def;
  def.rate = rate;
  def.velocity = vec(0, 5, 0);
  def.shortest = def.longest = lifetime;
  return def;
}

constexpr double endless = std::numeric_limits<double>::infinity();

double born(const World& world, ParticleId p) { return world.particles[p].born; }

/// ½ k |x|², with k the particle's radius times a factor.
std::shared_ptr<const Law> bowl(double factor) {
  Expressions g;
  Expr sum = g.constant(0.0);
  for (std::uint8_t i = 0; i < 3; i++) sum = g.add(sum, g.power(g.input({Role::position, 0, i, ""}), 2.0));
  const Expr energy = g.scale(g.multiply(g.input({Role::attribute, 0, 0, "radius"}), sum), 0.5 * factor);
  LawDef def;
  def.name = "bowl";
  return std::make_shared<Law>(point_potential(def, g, energy));
}

/// `age` times a factor, as the curve of a name.
std::shared_ptr<const Curves> growing(const std::string& name, double factor) {
  Expressions graph;
  const Expr output = graph.scale(graph.input(curve_age), factor);
  return with(nullptr, make_curve(name, graph, {&output, 1}));
}

}  // namespace

TEST_CASE("emitter: the n-th particle is born at n over the rate, whatever the step") {
  World world;
  world.settings.step = 1.0 / 60.0;
  const EmitterId emitter = add_emitter(world, fountain(1000.0 / 7.0, endless));
  advance(world, 7.0);
  const std::vector<ParticleId> made = particles(world);
  REQUIRE(made.size() == 1000);
  for (std::size_t n = 0; n < made.size(); n++)
    CHECK(born(world, made[n]) == Approx(static_cast<double>(n + 1) * 7.0 / 1000.0).epsilon(1e-15));
  CHECK(world.emitters[emitter].made == 1000);
  CHECK(world.emitters[emitter].count == 1000);
}

TEST_CASE("emitter: as many live as were born and not past their lifetimes when the step began, in a long run") {
  World world;
  const EmitterId emitter = add_emitter(world, fountain(300.0, 0.1));
  for (std::uint64_t k = 1; k <= 2400; k++) {
    step(world);
    const std::uint64_t born = 5 * k / 4, past = 5 * (k - 1) / 4;  // 300 1/s in steps of 1/240 s
    const std::uint64_t expected = born - (past > 30 ? past - 30 : 0);
    REQUIRE(world.emitters[emitter].count == expected);
    REQUIRE(world.particles.size() == expected);
  }
  CHECK(world.emitters[emitter].made == 3000);
}

TEST_CASE("emitter: a particle is where free fall takes it from the moment of its birth") {
  World world;
  world.settings.step = 0.04;
  EmitterDef def = fountain(9.0, endless);
  def.position.at = vec(1, 2, 3);
  add_emitter(world, def);
  advance(world, 1.2);
  const std::vector<ParticleId> made = particles(world);
  REQUIRE(made.size() == 10);
  for (ParticleId p : made) {
    const double age = world.time - born(world, p);
    const Vec3 expected = vec(1, 2 + 5 * age - 0.5 * 9.81 * age * age, 3);
    CHECK(norm(position(world, p) - expected) < 1e-13);
    CHECK(std::fabs(velocity(world, p)[1] - (5 - 9.81 * age)) < 1e-13);
  }
}

TEST_CASE("emitter: what it brings in and what dies is work from outside; the energy error stays nil") {
  World world;
  EmitterDef def = fountain(500.0, 0.5);
  def.spread = 0.4;
  def.mass = 0.3;
  add_emitter(world, def);
  advance(world, 3.0);
  CHECK(world.largest_kinetic > 100.0);
  CHECK(world.worst.energy < 1e-12);
  // Each birth brings m v²/2, and what dies half a second later takes m v²/2 of its launch with it.
  CHECK(energy(world).total() == Approx(world.work).epsilon(1e-11));
}

TEST_CASE("emitter: the energy that a law has of what comes and goes is counted too") {
  World world;
  world.settings.step = 1e-3;
  FamilyDef drops;
  drops.name = "drops";
  drops.radius = 2.0;
  EmitterDef def = fountain(200.0, 0.5);
  def.position.at = vec(1, 0, 0);
  def.family = add_family(world, drops);
  add_emitter(world, def);
  add_field(world, bowl(40.0), def.family);
  advance(world, 1.0);
  CHECK(world.largest_kinetic > 100.0);
  CHECK(world.worst.energy < 1e-4);
}

TEST_CASE("curves: energy that changes because a particle ages is work from outside") {
  World world;
  world.settings.gravity = zero3();
  world.settings.step = 1e-3;
  ParticleDef def;
  def.at = vec(1, 0, 0);
  def.curves = growing("radius", 3.0);
  const ParticleId p = add_particle(world, def);
  add_field(world, bowl(1.0), AnyId());
  advance(world, 3.0);
  // x'' = -3 t x has the solution that Airy's functions give: x(3) from DLMF 9.2, by a series of 60 terms.
  double x = 0.0, term = 1.0;
  for (int k = 1; k <= 60; k++) {
    x += term;
    term *= -3.0 * 27.0 / ((3.0 * k - 1.0) * 3.0 * k);
  }
  CHECK(position(world, p)[0] == Approx(x).margin(1e-4));
  CHECK(world.worst.energy < 1e-4);
}

TEST_CASE("emitter: the count follows the integral of a rate that changes with time") {
  World world;
  EmitterDef def = fountain(0.0, endless);
  def.rate_at = [](double t) { return 200.0 * (1.0 - std::cos(t)); };
  const EmitterId emitter = add_emitter(world, def);
  advance(world, 2.0);
  CHECK(std::fabs(static_cast<double>(world.emitters[emitter].made) - 200.0 * (2.0 - std::sin(2.0))) < 1.01);
}

TEST_CASE("emitter: a changed rate and a pause lose no part of a particle") {
  World world;
  world.settings.step = 0.01;
  const EmitterId emitter = add_emitter(world, fountain(0.7, endless));
  advance(world, 1.0);  // 0.7 of one
  set_rate(world, emitter, 0.1);
  advance(world, 2.0);  // 0.8
  set_enabled(world, emitter, false);
  advance(world, 3.0);
  set_enabled(world, emitter, true);
  set_rate(world, emitter, 1.0);
  advance(world, 4.0);  // 1.8
  REQUIRE(world.emitters[emitter].made == 1);
  CHECK(born(world, particles(world)[0]) == Approx(3.2).epsilon(1e-13));
}

TEST_CASE("emitter: two runs are the same to the last bit, and another emitter changes nothing of the first") {
  const auto run = [](bool with_another) {
    auto world = std::make_unique<World>();
    EmitterDef def = fountain(700.0, 0.0);
    def.shortest = 0.2;
    def.longest = 0.9;
    def.spread = 1.0;
    def.position.to = vec(1, 1, 1);
    const EmitterId first = add_emitter(*world, def);
    if (with_another) add_emitter(*world, fountain(1300.0, 0.3));
    advance(*world, 1.5);
    std::vector<double> state;
    for (ParticleId p : particles(*world)) {
      if (world->particles[p].emitter != first) continue;
      const Vec3 x = position(*world, p);
      state.insert(state.end(), {x[0], x[1], x[2], born(*world, p), world->particles[p].lifetime});
    }
    return state;
  };
  const std::vector<double> state = run(false);
  CHECK(state.size() > 1000);
  CHECK(state == run(false));
  CHECK(state == run(true));
}

TEST_CASE("emitter: directions fill the cone evenly, positions the box, lifetimes their range") {
  World world;
  world.settings.gravity = zero3();
  EmitterDef def = fountain(20000.0, 0.0);
  def.velocity = vec(0, 0, 2);
  def.spread = 1.0;
  def.position.at = vec(1, 0, 0);
  def.position.to = vec(-1, 4, 0);
  def.shortest = 2.0;
  def.longest = 4.0;
  add_emitter(world, def);
  advance(world, 1.0);
  double cosine = 0.0, least = 1.0, height = 0.0, lifetime = 0.0;
  for (ParticleId p : particles(world)) {
    const Vec3 v = velocity(world, p), from = position(world, p) - v * (world.time - born(world, p));
    CHECK(norm(v) == Approx(2.0));
    cosine += v[2] / 2.0;
    least = std::fmin(least, v[2] / 2.0);
    height += from[1];
    lifetime += world.particles[p].lifetime;
    CHECK((from[0] > -1 - 1e-12 && from[0] < 1 + 1e-12 && std::fabs(from[2]) < 1e-12));
  }
  const double n = 20000.0;
  CHECK(cosine / n == Approx(0.5 * (1.0 + std::cos(1.0))).margin(0.005));  // uniform in the cosine
  CHECK(least == Approx(std::cos(1.0)).margin(1e-3));
  CHECK(height / n == Approx(2.0).margin(0.04));
  CHECK(lifetime / n == Approx(3.0).margin(0.02));
}

TEST_CASE("emitter: on a point it moves with it, and goes with it") {
  World world;
  world.settings.gravity = zero3();
  ParticleDef carrier;
  carrier.velocity = vec(3, 0, 0);
  const ParticleId ship = add_particle(world, carrier);
  EmitterDef def = fountain(10.0, endless);
  def.position.point = world.particles[ship].points[0];
  def.name = "jet";
  const EmitterId emitter = add_emitter(world, def);
  advance(world, 1.0);
  for (ParticleId p : particles(world)) {
    if (p == ship) continue;
    CHECK(norm(velocity(world, p) - vec(3, 5, 0)) < 1e-13);
    CHECK(norm(position(world, p) - vec(3, 5 * (1.0 - born(world, p)), 0)) < 1e-12);
  }
  remove(world, ship);
  step(world);
  CHECK_FALSE(world.emitters.alive(emitter));
  CHECK_THAT(world.emitters.story(emitter), Contains("emitter 'jet'") && Contains("the end of its point"));
}

TEST_CASE("emitter: never more than max live at once") {
  World world;
  EmitterDef def = fountain(1000.0, 0.5);
  def.max = 100;
  const EmitterId emitter = add_emitter(world, def);
  for (int i = 0; i < 480; i++) {
    step(world);
    REQUIRE(world.emitters[emitter].count <= 100);
  }
  CHECK(world.emitters[emitter].count == 100);
}

TEST_CASE("emitter: a steady stream takes no more memory over many lifetimes") {
  const std::int64_t before = live_bytes();
  World world;
  EmitterDef def = fountain(5000.0, 0.0);
  def.shortest = 0.1;
  def.longest = 0.3;
  def.spread = 0.5;
  const EmitterId emitter = add_emitter(world, def);
  advance(world, 1.0);
  const std::uint32_t slots = world.particles.slots();
  const std::int64_t bytes = live_bytes() - before;
  const std::size_t told = world.log.size();
  advance(world, 5.0);
  CHECK(world.emitters[emitter].made > 24000);
  CHECK(world.particles.slots() <= slots + slots / 20);
  CHECK(world.points.slots() == world.particles.slots());
  CHECK(world.mortals.size() < 2 * slots);
  CHECK(world.log.size() == told);
  CHECK(live_bytes() - before < bytes + bytes / 20);
}

TEST_CASE("emitter: wrong definitions say what is wrong") {
  World world;
  const auto fails = [&](auto change, const char* message) {
    EmitterDef def = fountain(1.0, 1.0);
    def.name = "e";
    change(def);
    CHECK_THROWS_WITH(add_emitter(world, def), Contains(message));
    CHECK(world.emitters.empty());
  };
  fails([](EmitterDef& d) { d.rate = -1.0; }, "emitter 'e': rate must be >= 0 1/s");
  fails([](EmitterDef& d) { d.spread = 4.0; }, "spread must be from 0 to pi rad, got 4");
  fails([](EmitterDef& d) { d.longest = 0.5; }, "the longest lifetime must not be below the shortest");
  fails([](EmitterDef& d) { d.shortest = d.longest = 0.0; }, "lifetime must be > 0 s");
  fails([](EmitterDef& d) { d.max = 0; }, "max must be > 0");
  fails([](EmitterDef& d) { d.mass = 0.0; }, "mass must be > 0 kg");
  fails([](EmitterDef& d) { d.curves = growing("charge", 1.0); }, "it has no 'charge' that could follow its age");
  world.settings.step = 0.01;
  const EmitterId emitter = add_emitter(world, fountain(1e9, 1.0));
  CHECK_THROWS_WITH(step(world), Contains("rate must be at most 1e+08 1/s") && Contains("got 1e+09 1/s"));
  set_rate(world, emitter, [](double) { return 1e9; });
  CHECK_THROWS_WITH(step(world), Contains("rate must be at most 1e+08 1/s") && Contains("got 1e+09 1/s"));
  remove(world, emitter);
  step(world);
}

TEST_CASE("curves: radius, color and attributes follow the age; a value given ends that") {
  World world;
  FamilyDef sparks;
  sparks.name = "sparks";
  sparks.attributes = {{"heat", 7.0}};
  sparks.curves = growing("heat", 2.0);
  ParticleDef def;
  def.family = add_family(world, sparks);
  def.curves = growing("radius", 0.5);
  const ParticleId p = add_particle(world, def);
  advance(world, 1.0);
  CHECK(attribute(world, p, "heat") == 2.0);
  CHECK(attribute(world, p, "radius") == 0.5);
  CHECK(present_radius(world, p) == 0.5);
  set_attribute(world, p, "heat", 3.0);
  set_radius(world, p, 0.1);
  CHECK(attribute(world, p, "heat") == 3.0);
  CHECK(present_radius(world, p) == 0.1);
  CHECK(world.particles[p].curves == nullptr);

  Expressions graph;
  const Expr part = graph.divide(graph.input(curve_age), graph.input(curve_lifetime));
  const Expr rgba[] = {part, graph.constant(0.25), graph.constant(7.0), graph.subtract(graph.constant(1.0), part)};
  set_lifetime(world, p, 2.0);
  set_curve(world, p, make_curve("color", graph, rgba));
  CHECK(present_color(world, p) == Color{0.5f, 0.25f, 1.0f, 0.5f});
  set_color(world, p, {0, 1, 0, 1});
  CHECK(present_color(world, p) == Color{0, 1, 0, 1});
}

TEST_CASE("curves: two particles with curves of their own are told apart in one run of many") {
  World world;
  std::vector<std::uint32_t> slots;
  for (int i = 0; i < 2000; i++) {
    ParticleDef def;
    if (i % 3 > 0) def.curves = growing("radius", i % 3);
    slots.push_back(add_particle(world, def).slot - 1);
  }
  std::vector<double> radius(slots.size(), -1.0);
  double* const column = radius.data();
  follow_curves(world, "radius", 4.0, slots, {&column, 1});
  for (std::size_t i = 0; i < slots.size(); i++)
    CHECK(radius[i] == (i % 3 > 0 ? 4.0 * static_cast<double>(i % 3) : -1.0));
}
