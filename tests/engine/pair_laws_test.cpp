// Laws of pairs that reach everywhere.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/library_laws.hpp"

using namespace pantin;
using namespace pantin::testing;
using Catch::Contains;

TEST_CASE("library: spring and damper") {
  const auto spring = make("spring", {{"stiffness", 40.0}, {"length", 1.2}});
  REQUIRE(spring.size() == 1);
  CHECK(energy_at(spring[0], 1.5) == Approx(0.5 * 40.0 * 0.09));
  CHECK(tension_at(spring[0], 1.5) == Approx(12.0));
  CHECK(value_of(spring[0], pair_at(0.8), spring[0].stiffness) == Approx(40.0));
  check_central(spring, {0.4, 1.2, 3.0});

  const auto damped = make("spring", {{"stiffness", 40.0}, {"damping", 3.0}});
  REQUIRE(damped.size() == 2);
  CHECK(damped[0].parameters[1].present);
  CHECK(std::isnan(damped[0].parameters[1].value));
  CHECK(tension_at(damped[1], 1.5) == Approx(3.0 * 0.4));
  CHECK_FALSE(damped[1].has_energy());
  check_opposite({damped[1]}, pair_at(1.5));

  const auto damper = make("damper", {{"damping", 2.0}});
  CHECK(tension_at(damper[0], 0.7) == Approx(0.8));
  CHECK(damper[0].velocity_dependent);
}

TEST_CASE("library: gravitation and coulomb") {
  const auto newton = make("gravitation");
  CHECK(energy_at(newton[0], 2.0) == Approx(-6.6743e-11 * 1.5 * 2.5 / 2.0));
  CHECK(tension_at(newton[0], 2.0) == Approx(6.6743e-11 * 1.5 * 2.5 / 4.0));
  const auto soft = make("gravitation", {{"constant", 2.0}, {"softening", 0.5}});
  CHECK(tension_at(soft[0], 2.0) == Approx(2.0 * 1.5 * 2.5 * 2.0 / std::pow(4.25, 1.5)));
  check_central(soft, {0.1, 1.0, 4.0});

  const auto coulomb = make("coulomb", {{"constant", 3.0}});
  CHECK(energy_at(coulomb[0], 2.0) == Approx(3.0 * 0.7 * -1.3 / 2.0));
  CHECK(tension_at(coulomb[0], 2.0) == Approx(3.0 * 0.7 * 1.3 / 4.0));
  check_central(coulomb, {0.3, 1.0, 4.0});
  CHECK(make("coulomb")[0].parameters[0].value == 8.9875517873681764e9);
}

TEST_CASE("library: morse, buckingham and yukawa") {
  const auto morse = make("morse", {{"depth", 3.0}, {"steepness", 2.0}, {"length", 1.1}});
  CHECK(energy_at(morse[0], 1.1) == Approx(-3.0));
  const double e = std::exp(-2.0 * 0.4);
  CHECK(energy_at(morse[0], 1.5) == Approx(3.0 * (1.0 - e) * (1.0 - e) - 3.0));
  CHECK(tension_at(morse[0], 1.5) == Approx(2.0 * 3.0 * 2.0 * (1.0 - e) * e));
  check_central(morse, {0.7, 1.1, 2.0});

  const auto buckingham = make("buckingham", {{"repulsion", 50.0}, {"steepness", 3.0}, {"attraction", 2.0}});
  CHECK(energy_at(buckingham[0], 1.4) == Approx(50.0 * std::exp(-4.2) - 2.0 / std::pow(1.4, 6)));
  CHECK(tension_at(buckingham[0], 1.4) == Approx(-150.0 * std::exp(-4.2) + 12.0 / std::pow(1.4, 7)));
  check_central(buckingham, {0.9, 1.4, 3.0});

  const auto yukawa = make("yukawa", {{"strength", 2.0}, {"screening", 0.8}});
  CHECK(energy_at(yukawa[0], 1.6) == Approx(2.0 * std::exp(-2.0) / 1.6));
  CHECK(tension_at(yukawa[0], 1.6) == Approx(-2.0 * std::exp(-2.0) / 1.6 * (1.0 / 1.6 + 1.0 / 0.8)));
  check_central(yukawa, {0.3, 1.0, 3.0});
}

TEST_CASE("library: table") {
  std::vector<double> r, v, t;
  for (double x = 0.5; x < 3.0; x += 0.02) {
    r.push_back(x);
    v.push_back(std::exp(-x) * std::sin(4.0 * x));
    t.push_back(x * x - 2.0);
  }
  const auto potential = make_library_law("table", table_arguments(r, v, {}));
  CHECK(potential[0].cutoff == r.back());
  CHECK(energy_at(potential[0], 1.313) - energy_at(potential[0], 1.7) ==
        Approx(std::exp(-1.313) * std::sin(4.0 * 1.313) - std::exp(-1.7) * std::sin(6.8)).epsilon(1e-5));
  check_conservative(potential[0], pair_at(1.31));  // between points: at one the third derivative jumps
  check_stiffness(potential[0], 1.31);
  check_conservative(potential[0], pair_at(0.3));

  const auto tension = make_library_law("table", table_arguments(r, {}, t));
  CHECK(tension_at(tension[0], 1.313) == Approx(1.313 * 1.313 - 2.0).epsilon(1e-6));
  CHECK(energy_at(tension[0], 2.0) - energy_at(tension[0], 1.0) == Approx(7.0 / 3.0 - 2.0).epsilon(1e-5));
  CHECK(energy_at(tension[0], r.back()) == Approx(0.0).margin(1e-15));
  check_conservative(tension[0], pair_at(1.31));

  CHECK_THROWS_WITH(make("table"), Contains("either potentials [J] or tensions [N]"));
  CHECK_THROWS_WITH(make_library_law("table", table_arguments({1.0, 2.0}, {0.0}, {})), Contains("at least two points"));
  CHECK_THROWS_WITH(make_library_law("table", table_arguments({1.0, 1.0}, {0.0, 1.0}, {})), Contains("must rise"));
}
