// Laws of three and four particles.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/library_laws.hpp"

using namespace pantin;
using namespace pantin::testing;

TEST_CASE("library: angle") {
  const auto law = make("angle", {{"stiffness", 3.0}, {"angle", 1.9}});
  LawState state = some_particles(3, 1.0, 1);
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(0.0, 2.0, 0.0)};
  const double right = std::acos(0.0);
  CHECK(energy_of(law[0], state) == Approx(1.5 * std::pow(right - 1.9, 2)));
  CHECK(forces_of(law, state)[0][1] == Approx(-3.0 * (1.9 - right)));
  CHECK(present_value(state.x) == Approx(right));
  for (std::uint64_t seed : {2u, 3u, 4u}) {
    const auto any = some_particles(3, 1.0, seed);
    CHECK(energy_of(law[0], any) == Approx(1.5 * std::pow(present_value(any.x) - 1.9, 2)));
    check_conservative(law[0], any);
    check_opposite(law, any);
  }
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(-2.0, 0.0, 0.0)};
  CHECK(energy_of(law[0], state) == Approx(1.5 * std::pow(2.0 * right - 1.9, 2)));
  for (const Vec3& f : forces_of(law, state)) CHECK(largest(f) < 1e-8);
}

TEST_CASE("library: torsion") {
  const auto law = make("torsion", {{"stiffness", 2.0}, {"angle", 0.4}, {"fold", 3.0}});
  LawState state = some_particles(4, 1.0, 1);
  state.x = {vec(1.0, 0.0, 0.0), zero3(), vec(0.0, 0.0, 2.0), vec(0.0, 1.5, 2.0)};
  CHECK(std::fabs(present_value(state.x)) == Approx(std::acos(0.0)));
  for (std::uint64_t seed : {2u, 3u, 4u, 5u}) {
    const auto any = some_particles(4, 1.0, seed);
    CHECK(energy_of(law[0], any) == Approx(2.0 * (1.0 - std::cos(3.0 * (present_value(any.x) - 0.4)))));
    check_conservative(law[0], any);
    check_opposite(law, any);
  }
  // Seen along the middle bond the far one is turned clockwise: the torsion is positive (IUPAC).
  state.x = {vec(0.0, 1.0, 0.0), zero3(), vec(0.0, 0.0, -1.0), vec(1.0, 1.0, -1.0)};
  CHECK(present_value(state.x) == Approx(std::acos(0.0) / 2.0));
  state.x = {vec(0.0, 0.0, 0.0), vec(1.0, 0.0, 0.0), vec(2.0, 0.0, 0.0), vec(2.0, 1.0, 0.0)};
  for (const Vec3& f : forces_of(law, state)) CHECK(same(f, zero3()));
}
