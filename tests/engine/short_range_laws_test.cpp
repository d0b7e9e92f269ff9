// Laws of pairs that are 0 beyond a distance of their own.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/library_laws.hpp"

using namespace pantin;
using namespace pantin::testing;

TEST_CASE("library: lennard_jones and wca") {
  const auto lj = make("lennard_jones", {{"epsilon", 1.3}, {"sigma", 0.9}});
  const auto v = [](double r) { return 4.0 * 1.3 * (std::pow(0.9 / r, 12) - std::pow(0.9 / r, 6)); };
  CHECK(lj[0].cutoff == Approx(2.25));
  CHECK(energy_at(lj[0], 1.1) == Approx(v(1.1) - v(2.25)));
  CHECK(energy_at(lj[0], 2.25) == Approx(0.0).margin(1e-15));
  CHECK(tension_at(lj[0], 1.1) == Approx(-24.0 * 1.3 / 1.1 * (2.0 * std::pow(0.9 / 1.1, 12) - std::pow(0.9 / 1.1, 6))));
  check_central(lj, {0.8, 1.0, 2.0});
  LawArguments unshifted;
  unshifted.numbers = {{"epsilon", 1.3}, {"sigma", 0.9}};
  unshifted.shift = false;
  unshifted.cutoff = 3.0;
  const auto plain = make_library_law("lennard_jones", unshifted);
  CHECK(plain[0].cutoff == 3.0);
  CHECK(energy_at(plain[0], 1.1) == Approx(v(1.1)));

  const auto wca = make("wca", {{"epsilon", 1.3}, {"sigma", 0.9}});
  const double end = 0.9 * std::pow(2.0, 1.0 / 6.0);
  CHECK(wca[0].cutoff == Approx(end));
  CHECK(energy_at(wca[0], 0.95) == Approx(v(0.95) + 1.3));
  CHECK(energy_at(wca[0], end - 1e-9) == Approx(0.0).margin(1e-12));
  CHECK(tension_at(wca[0], end + 0.01) == 0.0);
  check_central(wca, {0.8, 0.95});
}

TEST_CASE("library: hydrophobic") {
  const auto tails = make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}});
  const double end = 0.9 * std::pow(2.0, 1.0 / 6.0), range = 1.6 * 0.9;
  CHECK(tails[0].cutoff == Approx(end + range));
  CHECK(energy_at(tails[0], end) == Approx(-1.5));
  const double half = end + 0.5 * range;
  CHECK(energy_at(tails[0], half) == Approx(-1.5 * std::pow(std::cos(std::acos(-1.0) / 4.0), 2)));
  CHECK(tension_at(tails[0], half) == Approx(1.5 * 0.5 * std::acos(-1.0) / range));
  CHECK(energy_at(tails[0], end + range + 0.1) == Approx(0.0).margin(1e-15));
  CHECK(energy_at(tails[0], 0.8) == Approx(6.0 * (std::pow(0.9 / 0.8, 12) - std::pow(0.9 / 0.8, 6)) + 1.5 - 1.5));
  check_central(tails, {0.8, 0.95, 1.3, half, 2.3});

  const auto others = make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}, {"range", 0.7}, {"attraction", -0.5}});
  CHECK(energy_at(others[0], end) == Approx(0.75));
  CHECK(tension_at(others[0], end + 0.3) < 0.0);
  check_central(others, {0.8, 1.3});
}

TEST_CASE("library: repel") {
  const auto repel = make("repel", {{"stiffness", 20.0}});  // radii 0.6 and 0.8 m
  CHECK(repel[0].touching);
  CHECK(tension_at(repel[0], 1.3) == Approx(-20.0 * std::pow(0.1, 1.5)));
  CHECK(energy_at(repel[0], 1.3) == Approx(0.4 * 20.0 * std::pow(0.1, 2.5)));
  CHECK(tension_at(repel[0], 1.5) == 0.0);
  CHECK(value_of(repel[0], pair_at(1.5), repel[0].stiffness) == 0.0);
  check_central(repel, {0.5, 1.3, 1.6});
}

TEST_CASE("library: flock") {
  const auto law = make("flock", {{"sight", 3.0}, {"separation", 0.4}, {"alignment", 0.7}, {"cohesion", 0.2}});
  const LawState state = pair_at(1.5);
  const Vec3 d = state.x[1] - state.x[0], u = state.v[1] - state.v[0];
  const Vec3 expected = (d * (0.2 - 0.4 / 2.25) + u * 0.7) * (0.75 * 0.75);
  const auto forces = forces_of(law, state);
  CHECK(largest(forces[0] - expected) < 1e-15);
  CHECK(same(forces[1], zero3()));
  CHECK(law[0].one_sided);
  CHECK(law[0].cutoff == 3.0);
  CHECK(same(forces_of(law, pair_at(3.1))[0], zero3()));
}
