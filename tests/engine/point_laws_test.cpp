// Laws of single particles.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/library_laws.hpp"

using namespace pantin;
using namespace pantin::testing;
using Catch::Contains;

TEST_CASE("library: drag, wind and vortex") {
  LawState state = some_particles(1, 1.0, 4);
  state.v[0] = vec(1.0, 2.0, -2.0);
  CHECK(same(forces_of(make("drag", {{"linear", 0.5}}), state)[0], vec(-0.5, -1.0, 1.0)));
  const Vec3 both = forces_of(make("drag", {{"linear", 0.5}, {"quadratic", 0.1}}), state)[0];
  CHECK(largest(both - vec(-0.8, -1.6, 1.6)) < 1e-15);
  state.v[0] = zero3();
  CHECK(same(forces_of(make("drag", {{"quadratic", 0.1}}), state)[0], zero3()));

  const auto wind = make("wind", {{"quadratic", 0.2}}, {{"velocity", vec(3.0, 0.0, 4.0)}});
  CHECK(largest(forces_of(wind, state)[0] - vec(3.0, 0.0, 4.0)) < 1e-15);
  CHECK(wind[0].velocity_dependent);

  state.x[0] = vec(1.0, 7.0, 2.0);
  const auto vortex = make("vortex", {{"circulation", 5.0}, {"core", 0.5}, {"linear", 0.3}},
                           {{"axis", vec(0.0, 2.0, 0.0)}, {"centre", vec(1.0, 0.0, 1.0)}});
  const double speed = 5.0 / (2.0 * std::acos(-1.0)) * 1.0 / (0.25 + 1.0);
  CHECK(largest(forces_of(vortex, state)[0] - vec(0.3 * speed, 0.0, 0.0)) < 1e-15);
  state.x[0] = vec(1.0, 3.0, 1.0);
  CHECK(same(forces_of(vortex, state)[0], zero3()));
  CHECK_THROWS_WITH(make("drag"), Contains("linear [N s/m] or quadratic [N s²/m²]"));
}

TEST_CASE("library: buoyancy") {
  const auto law = make("buoyancy", {{"density", 1000.0}, {"surface", 2.0}});
  LawState state = some_particles(1, 1.0, 4);
  state.attributes[0]["radius"] = 0.5;
  const double pi = std::acos(-1.0), weight = 1000.0 * 9.81;
  const auto lift = [&](double y) {
    state.x[0] = vec(0.3, y, -1.0);
    const Vec3 f = forces_of(law, state)[0];
    CHECK(f[0] == 0.0);
    CHECK(f[2] == 0.0);
    return f[1];
  };
  CHECK(lift(2.0) == Approx(weight * 2.0 / 3.0 * pi * 0.125));
  CHECK(lift(1.0) == Approx(weight * 4.0 / 3.0 * pi * 0.125));
  CHECK(lift(2.3) == Approx(weight * pi * 0.04 * (1.5 - 0.2) / 3.0));
  CHECK(lift(2.6) == 0.0);
  for (double y : {2.3, 1.9, 1.2}) {
    state.x[0] = vec(0.3, y, -1.0);
    check_conservative(law[0], state);
  }
}

TEST_CASE("library: thermostat") {
  const auto law = make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}});
  LawState state = some_particles(1, 1.0, 4);
  state.parameters = {{"boltzmann", 0.01}, {"step", 0.005}};
  const Vec3 kick = state.noise * std::sqrt(2.0 * 2.0 * 1.5 * 0.01 * 300.0 / 0.005);
  CHECK(largest(forces_of(law, state)[0] - (kick - state.v[0] * 3.0)) < 1e-12);
  CHECK(law[0].timed);
  CHECK(law[0].velocity_dependent);
  CHECK_THROWS_WITH(make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}, {"step", 0.1}}),
                    Contains("has no parameter \"step\""));
}

TEST_CASE("library: wall") {
  const std::map<std::string, Vec3> plane = {{"through", vec(0.0, 1.0, 0.0)}, {"normal", vec(0.0, 2.0, 0.0)}};
  const auto plain = make("wall", {{"stiffness", 100.0}}, plane);
  LawState state = some_particles(1, 1.0, 4);
  state.attributes[0]["radius"] = 0.5;
  state.x[0] = vec(3.0, 1.3, -1.0);
  state.v[0] = vec(3.0, -2.0, 4.0);
  REQUIRE(plain.size() == 1);
  CHECK(largest(forces_of(plain, state)[0] - vec(0.0, 20.0, 0.0)) < 1e-12);
  CHECK(energy_of(plain[0], state) == Approx(50.0 * 0.04));
  check_conservative(plain[0], state);

  const auto rough = make("wall", {{"stiffness", 100.0}, {"damping", 4.0}, {"friction", 0.5}, {"slip", 1e-9}}, plane);
  REQUIRE(rough.size() == 2);
  CHECK_FALSE(rough[1].has_energy());
  CHECK(largest(forces_of(rough, state)[0] - vec(-14.0 * 0.6, 28.0, -14.0 * 0.8)) < 1e-12);
  state.v[0] = vec(0.0, 9.0, 0.0);  // leaves so fast that damping would pull: nothing is left of the push
  CHECK(largest(forces_of(rough, state)[0]) < 1e-12);
  state.x[0] = vec(3.0, 1.6, -1.0);
  state.v[0] = vec(3.0, -2.0, 4.0);
  CHECK(same(forces_of(rough, state)[0], zero3()));
}
