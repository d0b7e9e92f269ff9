// What acts on pairs of neighbours, on connections and on single sites is run by one path.
#include "laws/run/law_on_sites.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "laws/run/bonds.hpp"
#include "laws/run/fields.hpp"
#include "laws/run/pairs.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

using Families = std::vector<std::uint32_t>;
constexpr double cutoff = 2.0;

/// Pulls by rate / (r² + 0.1)²: along the line of a pair, not linear in the distance.
std::shared_ptr<const Law> damper() {
  Expressions g;
  const Expr q = g.input({Role::distance2, 0, 0, {}});
  LawDef def;
  def.name = "damper";
  def.cutoff = cutoff;
  const Expr rate = g.multiply(g.input({Role::approach, 0, 0, {}}), g.power(q, -0.5));
  return std::make_shared<Law>(central_tension(def, g, g.multiply(rate, g.power(g.add(q, g.constant(0.1)), -2.0))));
}

/// Charges times each component of the velocity, cubed: of b relative to a, or of a single site.
std::shared_ptr<const Law> cubic(bool single) {
  Expressions g;
  std::vector<Expr> force;
  for (std::uint8_t k = 0; k < 3; k++) {
    const Expr v = g.input({single ? Role::velocity : Role::relative_velocity, 0, k, {}});
    const Expr charge = g.input({Role::attribute, 0, 0, "charge"});
    const Expr charges = single ? charge : g.multiply(charge, g.input({Role::attribute, 1, 0, "charge"}));
    force.push_back(g.multiply(charges, g.power(v, 3.0)));
  }
  LawDef def;
  def.name = "cubic";
  if (!single) def.cutoff = cutoff;
  return std::make_shared<Law>(single ? point_force(def, g, force) : pair_force(def, g, force));
}

/// Pairs that are nearer than the cutoff, each once.
BondList near_pairs(const Sites& sites) {
  BondList list;
  for (std::uint32_t i = 0; i < sites.n; i++)
    for (std::uint32_t j = i + 1; j < sites.n; j++)
      if (norm(sites.x[j] - sites.x[i]) < cutoff) {
        list.sites.push_back(i);
        list.sites.push_back(j);
      }
  return list;
}

/// Forces where velocities are changed [m/s] (sites), as the slopes have them [N] (sites).
std::vector<Vec3> forces_by_slopes(LawOnSites& law, const Sites& sites, Workers& workers,
                                   const std::vector<Vec3>& change) {
  SiteSlopes on_sites;
  on_sites.clear(sites.n);
  std::vector<VelocityPair> pairs;
  law.add_slopes(sites, {}, {}, {}, workers, on_sites, pairs);
  std::vector<Vec3> force(sites.n);
  for (std::size_t i = 0; i < sites.n; i++) force[i] = on_sites.force[i] + on_sites.slope[i] * change[i];
  for (const VelocityPair& p : pairs) {
    CHECK(norm(p.at - (sites.v[p.b] - sites.v[p.a])) < 1e-15);
    const Vec3 f = p.force + p.slope * (change[p.b] - change[p.a]);
    force[p.a] += f;
    force[p.b] -= f;
  }
  return force;
}

double largest_difference(const std::vector<Vec3>& a, const AlignedVector<Vec3>& b) {
  double most = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) {
    most = std::max(most, norm(a[i] - b[i]));
    scale = std::max(scale, norm(b[i]));
  }
  return most / scale;
}

/// Slopes give the forces at these velocities, and those at velocities near to them.
void check_slopes(LawOnSites& law, Sites sites, Workers& workers) {
  std::vector<Vec3> change(sites.n, zero3());
  sites.clear_forces();
  law.add_forces(sites, {}, {}, {}, workers);
  CHECK(largest_difference(forces_by_slopes(law, sites, workers, change), sites.nonconservative_force) < 1e-12);
  for (std::size_t i = 0; i < sites.n; i++) change[i] = vec(1, -2, 3) * (1e-6 * static_cast<double>(i % 5));
  const std::vector<Vec3> told = forces_by_slopes(law, sites, workers, change);
  for (std::size_t i = 0; i < sites.n; i++) sites.v[i] += change[i];
  sites.clear_forces();
  law.add_forces(sites, {}, {}, {}, workers);
  CHECK(largest_difference(told, sites.nonconservative_force) < 1e-8);
}

}  // namespace

TEST_CASE("law on sites: the same pairs as neighbours and as connections") {
  const std::shared_ptr<const Law> law = GENERATE(damper(), cubic(false));
  Sites sites = cases::random_sites({.count = 300, .edge = 6.0, .speed = 1.0}), others = sites;
  Workers workers;
  Pairs pairs(law, sites.names, workers);
  pairs.neighbours.build(sites, {}, Families{0}, Families{0}, cutoff, 0.3, workers);
  Bonds bonds(law, sites.names, workers);
  bonds.arrange(near_pairs(sites), sites);
  pairs.add_forces(sites, {}, {}, {}, workers);
  bonds.add_forces(others, {}, {}, {}, workers);
  for (std::size_t i = 0; i < sites.n; i++)
    REQUIRE(norm(sites.nonconservative_force[i] - others.nonconservative_force[i]) <
            1e-12 * (1.0 + norm(sites.nonconservative_force[i])));
  check_slopes(pairs, sites, workers);
  check_slopes(bonds, sites, workers);
  sites.v[137] = vec(infinity, 0, 0);
  for (const LawOnSites* each : {static_cast<const LawOnSites*>(&pairs), static_cast<const LawOnSites*>(&bonds)}) {
    const auto bad = each->find_bad(sites, {}, {}, {});
    REQUIRE(bad);
    CHECK((bad->sites[0] == 137 || bad->sites[1] == 137));
    CHECK(bad->distance == Approx(norm(sites.x[bad->sites[1]] - sites.x[bad->sites[0]])));
  }
}

TEST_CASE("law on sites: slopes of a law of single sites") {
  const Sites sites = cases::random_sites({.count = 5000, .speed = 1.0});
  Workers workers(2);
  Fields fields(cubic(true), sites.names, workers);
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < sites.n; i += 3) members.push_back(i);
  fields.arrange(members);
  check_slopes(fields, sites, workers);
}

TEST_CASE("law on sites: a copy tells the tensions of the last evaluation") {
  Sites sites = cases::random_sites({.count = 100, .speed = 1.0});
  Workers workers;
  Bonds bonds(damper(), sites.names, workers);
  bonds.arrange(near_pairs(sites), sites);
  bonds.add_forces(sites, {}, {}, {}, workers);
  Bonds copy = bonds;
  for (std::size_t k = 0; k < bonds.size(); k++) CHECK(copy.tension(k, sites, {}) == bonds.tension(k, sites, {}));
}
