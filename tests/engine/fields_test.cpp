// Laws run over single particles.
#include "laws/run/fields.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "support/allocations.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

Expr place(Expressions& g, std::uint8_t k) { return g.input({Role::position, 0, k, {}}); }

/// charge x y
std::shared_ptr<const Law> saddle() {
  Expressions g;
  const Expr product = g.multiply(place(g, 0), place(g, 1));
  LawDef def;
  def.name = "saddle";
  const Expr potential = g.multiply(g.input({Role::attribute, 0, 0, "charge"}), product);
  return std::make_shared<Law>(point_potential(def, g, potential));
}

std::vector<std::uint32_t> every(std::size_t step, std::size_t n) {
  std::vector<std::uint32_t> members;
  for (std::size_t i = 0; i < n; i += step) members.push_back(static_cast<std::uint32_t>(i));
  return members;
}

}  // namespace

TEST_CASE("fields: a potential acts on its members alone") {
  const std::size_t count = GENERATE(std::size_t{1}, std::size_t{700}, std::size_t{9000});
  const int threads = GENERATE(1, 2, 4);
  Sites sites = cases::random_sites({.count = count});
  Workers workers(threads);
  Fields fields(saddle(), sites.names, workers);
  fields.arrange(every(3, count));
  const double energy = fields.add_forces_and_energy(sites, {}, {}, {}, workers);
  double expected = 0.0;
  for (std::size_t i = 0; i < count; i++) {
    const double charge = sites.attributes[0][i];
    const Vec3 x = sites.x[i], force = i % 3 == 0 ? vec(-charge * x[1], -charge * x[0], 0) : zero3();
    REQUIRE(norm(sites.force[i] - force) <= 1e-13 * norm(force));
    if (i % 3 == 0) expected += charge * x[0] * x[1];
  }
  CHECK(energy == Approx(expected).epsilon(1e-12));
}

TEST_CASE("fields: a force of velocity and time has no energy") {
  Expressions g;
  std::vector<Expr> force;
  for (std::uint8_t k = 0; k < 3; k++)
    force.push_back(g.multiply(g.input({Role::velocity, 0, k, {}}), g.input({Role::time, 0, 0, {}})));
  LawDef def;
  def.name = "thrust";
  const auto law = std::make_shared<Law>(point_force(def, g, force));
  Sites sites = cases::random_sites({.count = 100, .speed = 2.0});
  Workers workers;
  Fields fields(law, sites.names, workers);
  fields.arrange(every(1, sites.n));
  CHECK(fields.add_forces_and_energy(sites, {}, {2.5, 0, 0}, {}, workers) == 0.0);
  for (std::size_t i = 0; i < sites.n; i++) {
    REQUIRE(norm(sites.nonconservative_force[i] - sites.v[i] * 2.5) < 1e-14);
    REQUIRE(largest(sites.force[i]) == 0.0);
  }
}

TEST_CASE("fields: in a box positions are seen within it") {
  Sites sites = cases::random_sites({.count = 1});
  sites.x[0] = vec(11, -3, 25);
  Workers workers;
  Fields fields(saddle(), sites.names, workers);
  fields.arrange(every(1, 1));
  fields.add_forces(sites, {vec(10, 10, 10)}, {}, {}, workers);
  CHECK(norm(sites.force[0] + vec(7, 1, 0) * sites.attributes[0][0]) < 1e-13);
}

TEST_CASE("fields: the site whose force is not finite is found, and nobody is also well") {
  Sites sites = cases::random_sites({.count = 5000});
  Workers workers;
  Fields fields(saddle(), sites.names, workers);
  CHECK(fields.add_forces_and_energy(sites, {}, {}, {}, workers) == 0.0);
  fields.arrange(every(1, sites.n));
  CHECK(!fields.find_bad(sites, {}, {}, {}));
  sites.attributes[0][4321] = infinity;
  const auto bad = fields.find_bad(sites, {}, {}, {});
  REQUIRE(bad);
  CHECK(bad->count == 1);
  CHECK(bad->sites[0] == 4321);
}

TEST_CASE("fields: a warm evaluation allocates nothing") {
  Sites sites = cases::random_sites({.count = 5000});
  Workers workers;
  Fields fields(saddle(), sites.names, workers);
  fields.arrange(every(1, sites.n));
  fields.add_forces_and_energy(sites, {}, {}, {}, workers);
  const std::uint64_t before = allocations();
  fields.add_forces(sites, {}, {}, {}, workers);
  fields.add_forces_and_energy(sites, {}, {}, {}, workers);
  CHECK(allocations() == before);
}
