// Laws run over connections give what a plain loop gives.
#include "laws/run/bonds.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "base/check.hpp"
#include "support/allocations.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

Expr distance2(Expressions& g) { return g.input({Role::distance2, 0, 0, {}}); }
Expr parameter(Expressions& g, const char* name) { return g.input({Role::parameter, 0, 0, name}); }

std::shared_ptr<const Law> spring() {
  Expressions g;
  const Expr stretch = g.subtract(g.square_root(distance2(g)), parameter(g, "length"));
  const Expr potential = g.scale(g.multiply(parameter(g, "stiffness"), g.multiply(stretch, stretch)), 0.5);
  LawDef def;
  def.name = "spring";
  def.parameters = {{"stiffness", 10.0, "N/m"}, {"length", 1.0, "m"}};
  return std::make_shared<Law>(central_potential(def, g, potential));
}

/// k (x1 - 2 x0 + x2)² / 2 with the first particle in the middle.
std::shared_ptr<const Law> bending() {
  Expressions g;
  Expr sum = g.constant(0.0);
  for (std::uint8_t k = 0; k < 3; k++) {
    const auto at = [&](std::uint8_t who) { return g.input({Role::position, who, k, {}}); };
    const Expr bend = g.add(g.subtract(at(1), g.scale(at(0), 2.0)), at(2));
    sum = g.add(sum, g.multiply(bend, bend));
  }
  LawDef def;
  def.name = "bending";
  def.parameters = {{"stiffness", 3.0, "N/m"}};
  const Expr potential = g.scale(g.multiply(parameter(g, "stiffness"), sum), 0.5);
  return std::make_shared<Law>(many_potential(def, 3, g, potential));
}

/// Random pairs, most of them near in the order of sites.
BondList random_bonds(std::size_t sites, std::size_t count, std::uint32_t reach, std::uint64_t seed = 5) {
  Random random{seed};
  BondList ties;
  ties.parameters.resize(2);
  while (ties.sites.size() < 2 * count) {
    const auto a = static_cast<std::uint32_t>(random.uniform() * static_cast<double>(sites));
    const double span = random.uniform() < 0.01 ? static_cast<double>(sites) : static_cast<double>(reach);
    const auto b = static_cast<std::uint32_t>((a + 1 + static_cast<std::size_t>(random.uniform() * span)) % sites);
    if (a == b) continue;
    ties.sites.push_back(a);
    ties.sites.push_back(b);
    ties.parameters[0].push_back(5.0 + random.uniform());
    ties.parameters[1].push_back(random.uniform());
  }
  return ties;
}

struct Expected {
  std::vector<Vec3> force;
  std::vector<double> tension;
  double energy = 0.0;
};

Expected springs_by_hand(const Sites& sites, const Box& box, const BondList& ties) {
  Expected expected;
  expected.force.assign(sites.n, zero3());
  for (std::size_t i = 0; i < ties.size(); i++) {
    const std::uint32_t a = ties.sites[2 * i], b = ties.sites[2 * i + 1];
    const double stiffness = ties.parameters.empty() ? 10.0 : ties.parameters[0][i];
    const double length = ties.parameters.empty() ? 1.0 : ties.parameters[1][i];
    const Vec3 d = box.nearest(sites.x[b] - sites.x[a]);
    const double stretch = norm(d) - length;
    expected.tension.push_back(stiffness * stretch);
    expected.energy += 0.5 * stiffness * stretch * stretch;
    const Vec3 f = d * (stiffness * stretch / norm(d));
    expected.force[a] += f;
    expected.force[b] -= f;
  }
  return expected;
}

double difference(const Sites& sites, const std::vector<Vec3>& expected) {
  double most = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < sites.n; i++) {
    most = std::max(most, norm(sites.force[i] - expected[i]));
    scale = std::max(scale, norm(expected[i]));
  }
  return most / scale;
}

}  // namespace

TEST_CASE("bonds: springs, each with its own stiffness and length or all with the same") {
  Sites sites = cases::random_sites({.count = 800});
  const std::size_t count = GENERATE(std::size_t{1}, std::size_t{127}, std::size_t{1000}, std::size_t{9000});
  const Box box = GENERATE(Box{}, Box{vec(10, 10, 10)});
  const bool own = GENERATE(true, false);
  BondList ties = random_bonds(sites.n, count, 30);
  if (!own) ties.parameters.clear();
  Workers workers;
  Bonds bonds(spring(), sites.names, workers);
  bonds.arrange(ties, sites);
  const std::vector<double> parameters = {10.0, 1.0};
  const double energy = bonds.add_forces_and_energy(sites, box, {}, parameters, workers);
  const Expected expected = springs_by_hand(sites, box, ties);
  CHECK(difference(sites, expected.force) < 1e-12);
  CHECK(energy == Approx(expected.energy).epsilon(1e-12));
  CHECK(bonds.size() == count);
  for (std::size_t i = 0; i < count; i++)
    REQUIRE(bonds.tension(i, sites, box) == Approx(expected.tension[i]).epsilon(1e-10).margin(1e-10));
  Vec3 sum = zero3();
  for (std::size_t i = 0; i < sites.n; i++) sum += sites.force[i];
  CHECK(norm(sum) < 1e-9);
}

TEST_CASE("bonds: the same bits for any number of threads") {
  const Sites start = cases::random_sites({.count = 50000, .edge = 40.0});
  const BondList ties = random_bonds(start.n, 100000, 1500);
  std::vector<Sites> made;
  std::vector<double> energies;
  for (const int threads : {1, 2, 4}) {
    Workers workers(threads);
    Bonds bonds(spring(), start.names, workers);
    Sites sites = start;
    bonds.arrange(ties, sites);
    bonds.add_forces(sites, {}, {}, {}, workers);
    energies.push_back(bonds.add_forces_and_energy(sites, {}, {}, {}, workers));
    made.push_back(sites);
  }
  for (std::size_t k = 1; k < 3; k++) {
    CHECK(std::memcmp(made[k].force.data(), made[0].force.data(), start.n * sizeof(Vec3)) == 0);
    CHECK(energies[k] == energies[0]);
  }
  std::vector<Vec3> twice = springs_by_hand(start, {}, ties).force;
  for (Vec3& f : twice) f += f;
  CHECK(difference(made[0], twice) < 1e-12);
}

TEST_CASE("bonds: triples, also across the edge of a box") {
  Sites sites = cases::random_sites({.count = 300});
  const Box box = GENERATE(Box{}, Box{vec(10, 10, 10)});
  BondList ties;
  ties.count = 3;
  for (std::uint32_t i = 0; i + 2 < sites.n; i++)
    for (const std::uint32_t who : {i + 1, i, i + 2}) ties.sites.push_back(who);
  Workers workers;
  Bonds bonds(bending(), sites.names, workers);
  bonds.arrange(ties, sites);
  const double energy = bonds.add_forces_and_energy(sites, box, {}, std::vector<double>{3.0}, workers);
  std::vector<Vec3> force(sites.n, zero3());
  double expected = 0.0;
  for (std::uint32_t i = 0; i + 2 < sites.n; i++) {
    const Vec3 bend = box.nearest(sites.x[i] - sites.x[i + 1]) + box.nearest(sites.x[i + 2] - sites.x[i + 1]);
    force[i] -= bend * 3.0;
    force[i + 1] += bend * 6.0;
    force[i + 2] -= bend * 3.0;
    expected += 1.5 * norm2(bend);
  }
  CHECK(difference(sites, force) < 1e-12);
  CHECK(energy == Approx(expected).epsilon(1e-12));
}

TEST_CASE("bonds: a damper feels the velocities of its ends") {
  Expressions g;
  const Expr tension = rate_of_distance(g);
  LawDef def;
  def.name = "damper";
  const auto law = std::make_shared<Law>(central_tension(def, g, tension));
  Sites sites = cases::random_sites({.count = 2, .speed = 1.0});
  BondList ties;
  ties.sites = {0, 1};
  Workers workers;
  Bonds bonds(law, sites.names, workers);
  bonds.arrange(ties, sites);
  bonds.add_forces(sites, {}, {}, {}, workers);
  const Vec3 d = sites.x[1] - sites.x[0];
  const double rate = dot(d, sites.v[1] - sites.v[0]) / norm(d);
  CHECK(norm(sites.nonconservative_force[0] - d * (rate / norm(d))) < 1e-14);
  CHECK(bonds.tension(0, sites, {}) == Approx(rate).epsilon(1e-13));
}

TEST_CASE("bonds: a spring whose ends are at one position pulls nowhere") {
  Sites sites = cases::random_sites({.count = 2, .edge = 0.0});
  BondList ties;
  ties.sites = {1, 0};
  Workers workers;
  Bonds bonds(spring(), sites.names, workers);
  bonds.arrange(ties, sites);
  bonds.add_forces(sites, {}, {}, std::vector<double>{10.0, 1.0}, workers);
  CHECK(largest(sites.force[0]) == 0.0);
  CHECK(!bonds.find_bad(sites, {}, {}, std::vector<double>{10.0, 1.0}));
}

TEST_CASE("bonds: the connection whose force is not finite is found") {
  Sites sites = cases::random_sites({.count = 100});
  BondList ties = random_bonds(sites.n, 500, 20);
  ties.parameters[0][321] = infinity;
  ties.parameters[0][432] = infinity;
  Workers workers;
  Bonds bonds(spring(), sites.names, workers);
  bonds.arrange(ties, sites);
  const auto bad = bonds.find_bad(sites, {}, {}, {});
  REQUIRE(bad);
  CHECK(bad->count == 2);
  CHECK(bad->sites[0] == ties.sites[642]);
  CHECK(bad->sites[1] == ties.sites[643]);
  CHECK(bad->distance == Approx(norm(sites.x[ties.sites[643]] - sites.x[ties.sites[642]])));
}

TEST_CASE("bonds: none is also well, and a warm evaluation allocates nothing") {
  Sites sites = cases::random_sites({.count = 3000});
  Workers workers;
  Bonds bonds(spring(), sites.names, workers);
  BondList none;
  none.parameters.resize(2);
  bonds.arrange(none, sites);
  CHECK(bonds.add_forces_and_energy(sites, {}, {}, {}, workers) == 0.0);
  bonds.arrange(random_bonds(sites.n, 9000, 50), sites);
  bonds.add_forces_and_energy(sites, {}, {}, {}, workers);
  const std::uint64_t before = allocations();
  bonds.add_forces(sites, {}, {}, {}, workers);
  bonds.add_forces_and_energy(sites, {}, {}, {}, workers);
  CHECK(allocations() == before);
}
