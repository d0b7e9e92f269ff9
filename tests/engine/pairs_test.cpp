// Laws run over pairs give what a plain double loop gives.
#include "laws/run/pairs.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "support/allocations.hpp"
#include "support/sites.hpp"

using namespace pantin;

namespace {

using Families = std::vector<std::uint32_t>;
using LawPtr = std::shared_ptr<const Law>;

Expr distance2(Expressions& g) { return g.input({Role::distance2, 0, 0, {}}); }
Expr attribute(Expressions& g, std::uint8_t who, const char* name) { return g.input({Role::attribute, who, 0, name}); }
Expr parameter(Expressions& g, const char* name) { return g.input({Role::parameter, 0, 0, name}); }
Expr component(Expressions& g, Role role, std::uint8_t k) { return g.input({role, 0, k, {}}); }

/// strength qa qb / (r² + 0.1)
LawPtr soft_charges(double cutoff = infinity) {
  Expressions g;
  const Expr charges = g.multiply(attribute(g, 0, "charge"), attribute(g, 1, "charge"));
  const Expr soft = g.add(distance2(g), g.constant(0.1));
  LawDef def;
  def.name = "soft charges";
  def.cutoff = cutoff;
  def.parameters = {{"strength", 2.0, "J m²"}};
  const Expr potential = g.multiply(parameter(g, "strength"), g.divide(charges, soft));
  return std::make_shared<Law>(central_potential(def, g, potential));
}

/// A force on a of the radii of both, the distance vector and the relative velocity; not symmetric.
LawPtr odd_force(bool one_sided, double cutoff) {
  Expressions g;
  std::vector<Expr> force;
  const Expr radius = g.add(attribute(g, 0, "radius"), g.scale(attribute(g, 1, "radius"), 0.5));
  for (std::uint8_t k = 0; k < 3; k++) {
    const Expr d = component(g, Role::displacement, k), u = component(g, Role::relative_velocity, k);
    force.push_back(g.multiply(radius, g.add(g.divide(d, g.add(distance2(g), g.constant(1.0))), u)));
  }
  LawDef def;
  def.name = "odd";
  def.cutoff = cutoff;
  def.one_sided = one_sided;
  return std::make_shared<Law>(pair_force(def, g, force));
}

struct Run {
  std::vector<Vec3> force, nonconservative_force;
  double energy = 0.0;
};

Run run(const Law& law, Sites sites, const Box& box, const Families& a, const Families& b, double rows_cutoff = 0.0,
        int threads = 1) {
  Workers workers(threads);
  Pairs pairs(std::make_shared<Law>(law), sites.names, workers);
  const double cutoff = rows_cutoff > 0.0 ? rows_cutoff : law.cutoff;
  pairs.neighbours.build(sites, box, a, b, cutoff, cutoff < infinity ? 0.3 : 0.0, workers);
  std::vector<double> parameters;
  for (const Parameter& p : law.parameters) parameters.push_back(p.value);
  Run run;
  Sites with_energy = sites;
  pairs.add_forces(sites, box, {0.5, 7, 3}, parameters, workers);
  run.energy = pairs.add_forces_and_energy(with_energy, box, {0.5, 7, 3}, parameters, workers);
  for (std::size_t i = 0; i < sites.n; i++)
    REQUIRE(norm(with_energy.force[i] - sites.force[i]) < 1e-12 * (1.0 + norm(sites.force[i])));
  run.force.assign(sites.force.begin(), sites.force.begin() + sites.n);
  run.nonconservative_force.assign(sites.nonconservative_force.begin(), sites.nonconservative_force.begin() + sites.n);
  return run;
}

using PairForce = std::function<Vec3(std::size_t a, std::size_t b, Vec3 d)>;

/// The sum over all pairs (a, b), or where the sets are equal over each pair once, of forces on a.
std::vector<Vec3> direct(const Sites& sites, const Box& box, const Families& a, const Families& b, double cutoff,
                         bool one_sided, const PairForce& force) {
  std::vector<Vec3> sum(sites.n, zero3());
  const auto has = [](const Families& set, std::uint32_t f) {
    return std::find(set.begin(), set.end(), f) != set.end();
  };
  for (std::size_t i = 0; i < sites.n; i++)
    for (std::size_t j = 0; j < sites.n; j++) {
      const bool once = a != b || one_sided ? i != j : i < j;
      if (!once || !has(a, sites.family[i]) || !has(b, sites.family[j])) continue;
      const Vec3 d = box.nearest(sites.x[j] - sites.x[i]);
      if (!(norm(d) < cutoff)) continue;
      const Vec3 f = force(i, j, d);
      sum[i] += f;
      if (!one_sided) sum[j] -= f;
    }
  return sum;
}

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) {
    most = std::max(most, norm(a[i] - b[i]));
    scale = std::max(scale, norm(b[i]));
  }
  return most / scale;
}

Vec3 soft_charge_force(const Sites& sites, std::size_t i, std::size_t j, Vec3 d) {
  const double soft = norm2(d) + 0.1;
  return d * (-4.0 * sites.attributes[0][i] * sites.attributes[0][j] / (soft * soft));
}

Vec3 odd(const Sites& sites, std::size_t i, std::size_t j, Vec3 d) {
  const auto& radius = sites.attributes[1];
  return (d / (norm2(d) + 1.0) + (sites.v[j] - sites.v[i])) * (radius[i] + 0.5 * radius[j]);
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

Box cube(double edge) { return {vec(edge, edge, edge)}; }

}  // namespace

TEST_CASE("pairs: a potential within one family") {
  const Sites sites = cases::random_sites({.count = 700});
  const double cutoff = GENERATE(1.0, 2.5, 5.0);
  const Box box = GENERATE(Box{}, cube(10.0));
  const Run made = run(*soft_charges(cutoff), sites, box, {0}, {0});
  double energy = 0.0;
  const std::vector<Vec3> expected =
      direct(sites, box, {0}, {0}, cutoff, false, [&](std::size_t i, std::size_t j, Vec3 d) {
        const double charges = 2.0 * sites.attributes[0][i] * sites.attributes[0][j];
        energy += charges / (norm2(d) + 0.1) - charges / (cutoff * cutoff + 0.1);
        return soft_charge_force(sites, i, j, d);
      });
  CHECK(difference(made.force, expected) < 1e-13);
  CHECK(made.energy == Approx(energy).epsilon(1e-12));
}

TEST_CASE("pairs: a potential without a cutoff") {
  const std::size_t count = GENERATE(std::size_t{2}, std::size_t{5}, std::size_t{900});
  const Sites sites = cases::random_sites({.count = count});
  const Run made = run(*soft_charges(), sites, {}, {0}, {0});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) { return soft_charge_force(sites, i, j, d); };
  CHECK(difference(made.force, direct(sites, {}, {0}, {0}, infinity, false, force)) < 1e-12);
}

TEST_CASE("pairs: without a cutoff what is of one body is left out, however many sites there are") {
  for (std::size_t n = 2; n < 60; n++) {
    CAPTURE(n);
    Sites sites = cases::random_sites({.count = n, .families = 2});
    for (std::size_t i = 0; i < n; i++) sites.kin[i].first = static_cast<std::uint32_t>(i / 3 + 1);
    const auto force = [&](std::size_t i, std::size_t j, Vec3 d) {
      return i / 3 == j / 3 ? zero3() : soft_charge_force(sites, i, j, d);
    };
    const Families zero = {0}, one = {1};
    for (const Families* second : {&zero, &one}) {
      const Run made = run(*soft_charges(), sites, {}, zero, *second);
      const std::vector<Vec3> wanted = direct(sites, {}, zero, *second, infinity, false, force);
      for (std::size_t i = 0; i < n; i++) CHECK(norm(made.force[i] - wanted[i]) < 1e-12);
    }
  }
}

TEST_CASE("pairs: a potential between two families") {
  const Sites sites = cases::random_sites({.count = 700, .families = 3});
  const double cutoff = GENERATE(2.5, infinity);
  const Run made = run(*soft_charges(cutoff), sites, {}, {2}, {0, 1});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) { return soft_charge_force(sites, i, j, d); };
  CHECK(difference(made.force, direct(sites, {}, {2}, {0, 1}, cutoff, false, force)) < 1e-13);
}

TEST_CASE("pairs: a force of velocities, which has no energy, between two families") {
  const Sites sites = cases::random_sites({.count = 600, .speed = 2.0, .families = 2});
  const Box box = GENERATE(Box{}, cube(10.0));
  const bool one_sided = GENERATE(false, true);
  const Run made = run(*odd_force(one_sided, 2.0), sites, box, {0}, {1});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) { return odd(sites, i, j, d); };
  CHECK(difference(made.nonconservative_force, direct(sites, box, {0}, {1}, 2.0, one_sided, force)) < 1e-13);
  CHECK(largest(made.force[0]) == 0.0);
  CHECK(made.energy == 0.0);
}

TEST_CASE("pairs: a one-sided force within one family acts both ways, each by its own attributes") {
  const Sites sites = cases::random_sites({.count = 600, .speed = 2.0});
  const Run made = run(*odd_force(true, 2.0), sites, {}, {0}, {0});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) { return odd(sites, i, j, d); };
  CHECK(difference(made.nonconservative_force, direct(sites, {}, {0}, {0}, 2.0, true, force)) < 1e-13);
}

TEST_CASE("pairs: a one-sided central law within one family pulls each by its own attribute") {
  Expressions g;
  const Expr tension = g.multiply(attribute(g, 0, "charge"), g.square_root(distance2(g)));
  LawDef def;
  def.name = "own charge";
  def.cutoff = 2.0;
  def.one_sided = true;
  const Law law = central_tension(def, g, tension);
  const Sites sites = cases::random_sites();
  const Run made = run(law, sites, {}, {0}, {0});
  const auto force = [&](std::size_t i, std::size_t, Vec3 d) { return d * sites.attributes[0][i]; };
  CHECK(difference(made.nonconservative_force, direct(sites, {}, {0}, {0}, 2.0, true, force)) < 1e-13);
}

TEST_CASE("pairs: a damper works against approach") {
  Expressions g;
  const Expr tension = rate_of_distance(g);
  LawDef def;
  def.name = "damper";
  def.cutoff = 2.0;
  const Law law = central_tension(def, g, tension);
  const Sites sites = cases::random_sites({.speed = 1.0});
  const Run made = run(law, sites, cube(10.0), {0}, {0});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) {
    return d * (dot(d, sites.v[j] - sites.v[i]) / norm2(d));
  };
  CHECK(difference(made.nonconservative_force, direct(sites, cube(10.0), {0}, {0}, 2.0, false, force)) < 1e-12);
}

TEST_CASE("pairs: a touching law acts where the radii overlap") {
  Law law = *soft_charges(3.0);
  law.touching = true;
  const Sites sites = cases::random_sites();
  const Run made = run(law, sites, {}, {0}, {0});
  const auto force = [&](std::size_t i, std::size_t j, Vec3 d) {
    const bool touch = norm(d) < sites.attributes[1][i] + sites.attributes[1][j];
    return touch ? soft_charge_force(sites, i, j, d) : zero3();
  };
  CHECK(difference(made.force, direct(sites, {}, {0}, {0}, 3.0, false, force)) < 1e-13);
}

TEST_CASE("pairs: forces of a law that is not one-sided sum to zero") {
  const Sites sites = cases::random_sites({.count = 3000, .edge = 15.0, .speed = 1.0});
  for (const LawPtr& law : {soft_charges(2.5), odd_force(false, 2.5)}) {
    const Run made = run(*law, sites, cube(15.0), {0}, {0});
    Vec3 sum = zero3();
    double scale = 0.0;
    for (std::size_t i = 0; i < sites.n; i++) {
      sum += made.force[i] + made.nonconservative_force[i];
      scale += norm(made.force[i] + made.nonconservative_force[i]);
    }
    CHECK(norm(sum) < 1e-13 * scale);
  }
}

TEST_CASE("pairs: the same bits for any number of threads") {
  const Sites sites = cases::random_sites({.count = 6000, .edge = 20.0, .families = 2});
  const double cutoff = GENERATE(2.0, infinity);
  const Families b = GENERATE(Families{0}, Families{1});
  const Run one = run(*soft_charges(cutoff), sites, {}, {0}, b, 0.0, 1);
  for (const int threads : {2, 4}) {
    const Run other = run(*soft_charges(cutoff), sites, {}, {0}, b, 0.0, threads);
    CHECK(same_bits(one.force, other.force));
    CHECK(one.energy == other.energy);
  }
}

TEST_CASE("pairs: at one position and beyond the cutoff a singular law stays finite") {
  Expressions g;
  const Expr r2 = distance2(g);
  const Expr r6 = g.power(r2, -3.0), potential = g.scale(g.subtract(g.multiply(r6, r6), r6), 4.0);
  LawDef def;
  def.name = "lennard-jones";
  def.cutoff = 2.5;
  const Law law = central_potential(def, g, potential);
  Sites sites = cases::random_sites({.count = 2});
  for (const double r : {0.0, 1e-300, 1e-8, 2.49, 2.6, 1e9}) {
    sites.x[0] = vec(1, 2, 3);
    sites.x[1] = vec(1 + r, 2, 3);
    const Run made = run(law, sites, {}, {0}, {0});
    CHECK(finite(made.force[0]));
    CHECK(std::isfinite(made.energy));
    if (r > 2.5) CHECK(made.energy == 0.0);
    if (r > 2.5 || r == 0.0) CHECK(largest(made.force[0]) == 0.0);
  }
}

TEST_CASE("pairs: noise is the same for both of a pair") {
  Expressions g;
  const Expr noise = g.input({Role::noise, 0, 0, {}});
  LawDef def;
  def.name = "noise";
  def.cutoff = 2.0;
  const Law law = central_tension(def, g, noise);
  const Sites sites = cases::random_sites();
  const Run made = run(law, sites, {}, {0}, {0}), again = run(law, sites, {}, {0}, {0}, 2.5);
  Vec3 sum = zero3();
  for (const Vec3 f : made.nonconservative_force) sum += f;
  CHECK(norm(sum) < 1e-11);
  CHECK(norm(made.nonconservative_force[3]) > 0.1);
  CHECK(made.nonconservative_force.size() == again.nonconservative_force.size());
}

TEST_CASE("pairs: what is called sees each pair that is near enough, and acts as a program does") {
  struct Charges : Called {
    std::size_t seen = 0;
    void run(const Block& block) override {
      for (std::size_t k = 0; k < static_cast<std::size_t>(block.n); k++) {
        const double soft = block.inputs[1][k] + 0.1, charges = block.inputs[0][k] * block.inputs[2][k];
        REQUIRE(block.particles[0][k] != block.particles[1][k]);
        block.outputs[0][k] = -2.0 * block.parameters[0] * charges / (soft * soft);
        block.outputs[1][k] = block.parameters[0] * charges / soft;
        seen++;
      }
    }
  };
  Law law = *soft_charges();
  law.cutoff = 2.0;
  Law called = law;
  const auto charges = std::make_shared<Charges>();
  called.called = charges;
  called.called_energy = true;
  called.inputs_wanted = {
      {Role::attribute, 0, 0, "charge"}, {Role::distance2, 0, 0, {}}, {Role::attribute, 1, 0, "charge"}};
  const Sites sites = cases::random_sites();
  const Run expected = run(law, sites, {}, {0}, {0}), made = run(called, sites, {}, {0}, {0});
  CHECK(difference(made.force, expected.force) < 1e-14);
  CHECK(made.energy == Approx(expected.energy).epsilon(1e-13));
  std::size_t pairs = 0;
  direct(sites, {}, {0}, {0}, 2.0, false, [&](std::size_t, std::size_t, Vec3) {
    pairs++;
    return zero3();
  });
  CHECK(charges->seen == 2 * pairs);
}

TEST_CASE("pairs: the pair whose force is not finite is found") {
  Expressions g;
  const Expr tension = g.apply(Function::log, g.subtract(distance2(g), g.constant(0.25)));
  LawDef def;
  def.name = "log";
  def.cutoff = 2.0;
  const auto law = std::make_shared<Law>(central_tension(def, g, tension));
  Sites sites = cases::random_sites({.count = 3, .edge = 0.0});
  for (std::size_t i = 0; i < 3; i++) sites.x[i] = vec(static_cast<double>(i), 0, 0);
  Workers workers;
  Pairs pairs(law, sites.names, workers);
  pairs.neighbours.build(sites, {}, Families{0}, Families{0}, 2.0, 1.0, workers);
  CHECK(!pairs.find_bad(sites, {}, {}, {}));
  sites.x[2][0] = 1.375;
  const auto bad = pairs.find_bad(sites, {}, {}, {});
  REQUIRE(bad);
  CHECK(bad->count == 2);
  CHECK(bad->sites[0] + bad->sites[1] == 3);
  CHECK(bad->distance == 0.375);
}

TEST_CASE("pairs: an attribute that nobody has is refused") {
  CHECK_THROWS_WITH(Pairs(soft_charges(), std::vector<std::string>{"radius"}, Workers{}),
                    "soft charges: there is no attribute \"charge\"");
}

TEST_CASE("pairs: a warm evaluation allocates nothing") {
  Sites sites = cases::random_sites({.count = 2000});
  Workers workers;
  const LawPtr law = soft_charges(2.0);
  Pairs pairs(law, sites.names, workers);
  pairs.neighbours.build(sites, {}, Families{0}, Families{0}, 2.0, 0.3, workers);
  const std::vector<double> parameters = {2.0};
  pairs.add_forces(sites, {}, {}, parameters, workers);
  const std::uint64_t before = allocations();
  pairs.add_forces(sites, {}, {}, parameters, workers);
  pairs.add_forces_and_energy(sites, {}, {}, parameters, workers);
  CHECK(allocations() == before);
}
