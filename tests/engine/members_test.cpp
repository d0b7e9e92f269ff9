// Particles that come and go among laws: what acts then is what would act on a world made anew.
#include <catch2/catch.hpp>
#include <map>
#include <memory>

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "edit/edit.hpp"
#include "edit/emitter.hpp"
#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

/// k (c² - r²)² within the cutoff c, not between what is one or two connections apart.
std::shared_ptr<const Law> soft_cores(double cutoff, double strength) {
  Expressions g;
  const Expr depth = g.subtract(g.constant(cutoff * cutoff), g.input({Role::distance2, 0, 0, {}}));
  LawDef def;
  def.name = "soft cores";
  def.cutoff = cutoff;
  def.exclude = 2;
  const Expr energy = g.scale(g.multiply(depth, depth), strength);
  return std::make_shared<Law>(central_potential(def, g, energy));
}

/// m k |x|² / 2
std::shared_ptr<const Law> well(double k) {
  Expressions g;
  Expr sum = g.constant(0.0);
  for (std::uint8_t i = 0; i < 3; i++) sum = g.add(sum, g.power(g.input({Role::position, 0, i, ""}), 2.0));
  LawDef def;
  def.name = "well";
  const Expr energy = g.scale(g.multiply(g.input({Role::attribute, 0, 0, "mass"}), sum), 0.5 * k);
  return std::make_shared<Law>(point_potential(def, g, energy));
}

/// k r²
std::shared_ptr<const Law> string_of(double k) {
  Expressions g;
  LawDef def;
  def.name = "string";
  const Expr energy = g.scale(g.input({Role::distance2, 0, 0, {}}), k);
  return std::make_shared<Law>(central_potential(def, g, energy));
}

void prepare(World& world, double step) {
  world.settings.gravity = zero3();
  world.settings.step = step;
}

FamilyId make_family(World& world, const char* name) {
  FamilyDef def;
  def.name = name;
  return add_family(world, def);
}

EmitterId pour(World& world, FamilyId family, double rate, double shortest, double longest) {
  EmitterDef def;
  def.rate = rate;
  def.position.at = vec(-1, -1, -1);
  def.position.to = vec(1, 1, 1);
  def.velocity = vec(0, 1, 0);
  def.spread = 3.0;
  def.shortest = shortest;
  def.longest = longest;
  def.mass = 0.5;
  def.family = family;
  return add_emitter(world, def);
}

std::map<std::uint64_t, Vec3> forces_by_serial(const World& world) {
  const Sites& sites = world.forces->sites;
  std::map<std::uint64_t, Vec3> forces;
  for (std::size_t i = 0; i < sites.n; i++)
    if (sites.particle[i] != Forces::none) forces[sites.serial[i]] = sites.force[i];
  return forces;
}

void check_against_anew(World& world) {
  const double energy = law_energy(world);
  const auto forces = forces_by_serial(world);
  const FieldId field = world.fields.ids().front();
  set_enabled(world, field, false);
  set_enabled(world, field, true);
  refresh_laws(world);
  CHECK(law_energy(world) == Approx(energy).epsilon(1e-13));
  const auto anew = forces_by_serial(world);
  REQUIRE(forces.size() == anew.size());
  double scale = 0.0, wrong = 0.0;
  for (const auto& [serial, force] : anew) {
    REQUIRE(forces.contains(serial));
    scale = std::max(scale, norm(force));
    wrong = std::max(wrong, norm(force - forces.at(serial)));
  }
  CHECK(scale > 0.0);
  CHECK(wrong < 1e-14 * scale);
}

}  // namespace

TEST_CASE("members: in a stream through a field forces and energy are those of a world made anew") {
  World world;
  prepare(world, 1e-3);
  const FamilyId drops = make_family(world, "drops");
  add_field(world, well(9.0), drops);
  pour(world, drops, 2e4, 0.005, 0.02);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 17; k++) step(world);
    const std::vector<ParticleId> here = world.particles.ids();
    for (std::size_t k = 0; k < here.size(); k += 7) remove(world, here[k]);
    for (int k = 0; k < 11 * i; k++) {
      ParticleDef def;
      def.at = vec(0.1 * k, 1, 0);
      def.family = drops;
      add_particle(world, def);
    }
    refresh_laws(world);
    check_against_anew(world);
  }
  CHECK(world.forces->sites.n > 150);
  CHECK(world.worst.energy < 1e-5);
}

TEST_CASE("members: connections go on holding particles whose sites are put elsewhere") {
  World world;
  prepare(world, 1e-3);
  const FamilyId drops = make_family(world, "drops");
  add_field(world, well(9.0), drops);
  std::vector<ParticleId> here;
  for (int i = 0; i < 20; i++) {
    ParticleDef def;
    def.at = vec(0.1 * i, 0.01 * i * i, 0);
    def.family = drops;
    here.push_back(add_particle(world, def));
  }
  ConnectionDef ends;
  ends.ends = {End{here[18]}, End{here[19]}};
  add_connection(world, string_of(20.0), ends);
  step(world);
  for (std::size_t k = 0; k < 12; k += 2) {
    remove(world, here[k]);
    remove(world, here[k + 1]);
    refresh_laws(world);
    check_against_anew(world);
    step(world);
  }
  CHECK(world.worst.energy < 1e-3);
}

TEST_CASE("members: the same of pairs, next to a chain, a body and a nail that stay") {
  World world;
  prepare(world, 1e-3);
  const FamilyId drops = make_family(world, "drops"), others = make_family(world, "others");
  add_interaction(world, soft_cores(0.4, 50.0), drops, drops);
  add_field(world, well(9.0), drops);
  pour(world, drops, 8e3, 0.01, 0.05);
  pour(world, others, 8e3, 0.01, 0.05);
  std::vector<ParticleId> chain;
  for (int i = 0; i < 6; i++) {
    ParticleDef def;
    def.at = vec(0.2 * i, 0.1, 0);
    def.family = drops;
    chain.push_back(add_particle(world, def));
    if (i == 0) continue;
    ConnectionDef ends;
    ends.ends = {End{chain[static_cast<std::size_t>(i) - 1]}, End{chain.back()}};
    add_connection(world, string_of(20.0), ends);
  }
  BodyDef body;
  body.mass = 1.0;
  for (double x : {0.0, 0.3, 0.6}) {
    PointDef point;
    point.at = vec(x, 0.2 * x * x, 0);
    point.mass = 1.0;
    point.family = drops;
    body.points.push_back(point);
  }
  const BodyId bar = add_body(world, body);
  add_nail(world, world.bodies[bar].points[0]);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 25; k++) step(world);
    check_against_anew(world);
  }
  CHECK(world.forces->sites.n > 150);
  CHECK(world.failure.empty());
}

TEST_CASE("members: whatever order they are removed and made in") {
  World world;
  prepare(world, 1e-3);
  const FamilyId drops = make_family(world, "drops");
  add_interaction(world, soft_cores(0.5, 5.0), drops, drops);
  add_field(world, well(1.0), drops);
  Random random{5};
  std::vector<ParticleId> here;
  for (int round = 0; round < 30; round++) {
    const int made = static_cast<int>(12.0 * random.uniform()), gone = static_cast<int>(10.0 * random.uniform());
    for (int i = 0; i < made; i++) {
      ParticleDef def;
      def.at = vec(random.uniform(), random.uniform(), random.uniform());
      def.family = drops;
      here.push_back(add_particle(world, def));
    }
    for (int i = 0; i < gone && !here.empty(); i++) {
      const auto which = static_cast<std::size_t>(random.uniform() * static_cast<double>(here.size()));
      remove(world, here[which]);
      here.erase(here.begin() + static_cast<std::ptrdiff_t>(which));
    }
    step(world);
    REQUIRE(world.failure.empty());
    REQUIRE(world.forces->sites.n == here.size());
    if (round % 5 == 4 && !here.empty()) check_against_anew(world);
  }
  CHECK(world.worst.energy < 1e-4);
}

TEST_CASE("members: the same bits for one, two and four threads") {
  std::vector<std::vector<Vec3>> positions;
  for (int threads : {1, 2, 4}) {
    World world;
    prepare(world, 1e-3);
    world.workers = std::make_unique<Workers>(threads);
    const FamilyId drops = make_family(world, "drops");
    add_interaction(world, soft_cores(0.3, 50.0), drops, drops);
    add_field(world, well(9.0), drops);
    pour(world, drops, 1e5, 0.01, 0.02);
    for (int k = 0; k < 25; k++) step(world);
    positions.emplace_back();
    for (ParticleId id : world.particles.ids()) positions.back().push_back(position(world, id));
  }
  REQUIRE(positions[0].size() > 1000);
  for (std::size_t run = 1; run < positions.size(); run++) {
    REQUIRE(positions[run].size() == positions[0].size());
    for (std::size_t i = 0; i < positions[0].size(); i++) REQUIRE(same(positions[run][i], positions[0][i]));
  }
}

TEST_CASE("members: a newborn that lacks what a law reads stops the world, and says so") {
  World world;
  prepare(world, 1e-3);
  Expressions g;
  const Expr charge = g.input({Role::attribute, 0, 0, "charge"});
  const Expr energy = g.multiply(charge, g.input({Role::position, 0, 0, ""}));
  LawDef def;
  def.name = "field of charges";
  FamilyDef ions;
  ions.name = "ions";
  ions.attributes = {{"charge", 1.0}};
  ParticleDef ion;
  ion.family = add_family(world, ions);
  add_particle(world, ion);
  add_field(world, std::make_shared<Law>(point_potential(def, g, energy)), {});
  step(world);
  REQUIRE(world.failure.empty());
  add_particle(world, {});
  step(world);
  CHECK_THAT(world.failure, Catch::Contains("charge"));
}

namespace {

/// The same on all: noise, and what pulls in proportion to the velocity.
std::shared_ptr<const Law> force_of(double noise, double drag) {
  Expressions g;
  std::vector<Expr> force;
  for (std::uint8_t i = 0; i < 3; i++) {
    force.push_back(g.scale(g.input({Role::position, 0, i, ""}), -1.0));
    if (noise > 0.0) force[i] = g.add(force[i], g.scale(g.input({Role::noise, 0, i, ""}), noise));
    if (drag > 0.0) force[i] = g.subtract(force[i], g.scale(g.input({Role::velocity, 0, i, ""}), drag));
  }
  LawDef def;
  def.name = "what is without energy";
  return std::make_shared<Law>(point_force(def, g, force));
}

using PerSite = std::vector<Vec3> Forces::*;

std::map<std::uint64_t, Vec3> by_serial(const World& world, PerSite list) {
  const Forces& f = *world.forces;
  REQUIRE((f.*list).size() >= f.sites.n);
  std::map<std::uint64_t, Vec3> values;
  for (std::size_t i = 0; i < f.sites.n; i++)
    if (f.sites.particle[i] != Forces::none) values[f.sites.serial[i]] = (f.*list)[i];
  return values;
}

/// In a stream what is kept of each particle is that of a world made anew, whose forces are those of the present state.
void check_kept(World& world, PerSite list) {
  const FamilyId drops = world.families.ids().front();
  pour(world, drops, 2e3, 0.005, 0.02);
  for (int k = 0; k < 60; k++) {
    step(world);
    const std::vector<ParticleId> here = world.particles.ids();
    for (std::size_t i = 0; i < here.size(); i += 9) remove(world, here[i]);
    ParticleDef def;
    def.at = vec(0.1 * k, 1, 0);
    def.family = drops;
    add_particle(world, def);
    refresh_laws(world);
    const auto kept = by_serial(world, list);
    const FieldId field = world.fields.ids().front();
    set_enabled(world, field, false);
    set_enabled(world, field, true);
    refresh_laws(world);
    const auto anew = by_serial(world, list);
    REQUIRE(anew.size() == kept.size());
    for (const auto& [serial, value] : anew) REQUIRE(norm(value - kept.at(serial)) <= 1e-14 * norm(value));
  }
}

}  // namespace

TEST_CASE("members: noise that errors are told without is known of newborns, and stays with its particle") {
  World world;
  prepare(world, 1e-3);
  world.settings.accuracy = 0.1;
  add_field(world, force_of(0.01, 0.0), make_family(world, "drops"));
  check_kept(world, &Forces::noise);
  CHECK(norm(world.forces->noise.front()) > 0.0);
}

TEST_CASE("members: what laws of velocity do not damp is known of newborns without kicks, too") {
  World world;
  prepare(world, 1e-3);
  set_integrator(world, Integrator::rk4);
  add_field(world, force_of(0.0, 0.1), make_family(world, "drops"));
  check_kept(world, &Forces::undamped);
}
