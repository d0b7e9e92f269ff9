#include "support/library_laws.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/random.hpp"

namespace pantin::testing {

std::vector<Law> make(const std::string& name, Numbers numbers, std::map<std::string, Vec3> vectors) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  arguments.vectors = std::move(vectors);
  return make_library_law(name, arguments);
}

std::vector<std::vector<Law>> one_of_each() {
  const Numbers drag = {{"linear", 0.3}, {"quadratic", 0.2}};
  return {make("spring", {{"stiffness", 40.0}, {"length", 1.2}, {"damping", 2.0}}),
          make("damper", {{"damping", 2.0}}),
          make("gravitation", {{"constant", 2.0}, {"softening", 0.1}}),
          make("coulomb", {{"constant", 2.0}}),
          make("lennard_jones", {{"epsilon", 1.3}, {"sigma", 0.9}}),
          make("wca", {{"epsilon", 1.3}, {"sigma", 0.9}}),
          make("morse", {{"depth", 3.0}, {"steepness", 2.0}, {"length", 1.1}}),
          make("buckingham", {{"repulsion", 50.0}, {"steepness", 3.0}, {"attraction", 2.0}}),
          make("yukawa", {{"strength", 2.0}, {"screening", 0.8}}),
          make_library_law("table", table_arguments({0.4, 0.8, 1.3, 2.0}, {3.0, 1.0, -1.0, 0.0}, {})),
          make("hydrophobic", {{"strength", 1.5}, {"size", 0.9}}),
          make("repel", {{"stiffness", 20.0}}),
          make("flock", {{"sight", 3.0}, {"separation", 0.4}, {"alignment", 0.7}, {"cohesion", 0.2}}),
          make("drag", drag),
          make("wind", drag, {{"velocity", vec(1.0, 2.0, 3.0)}}),
          make("vortex", {{"circulation", 5.0}, {"core", 0.5}, {"linear", 0.3}}, {{"axis", vec(0.0, 2.0, 1.0)}}),
          make("buoyancy", {{"density", 1000.0}}),
          make("thermostat", {{"rate", 2.0}, {"temperature", 300.0}}),
          make("wall", {{"stiffness", 100.0}, {"damping", 4.0}, {"friction", 0.5}}, {{"normal", vec(0.0, 1.0, 1.0)}}),
          make("angle", {{"stiffness", 3.0}, {"angle", 1.9}}),
          make("torsion", {{"stiffness", 2.0}, {"angle", 0.4}, {"fold", 3.0}})};
}

LawState some_particles(std::size_t count, double size, std::uint64_t seed) {
  Random random{seed, 0};
  const auto vector = [&](double scale) {
    return vec(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * scale;
  };
  LawState state;
  for (std::size_t i = 0; i < count; i++) {
    state.x.push_back(vector(2.0 * size));
    state.v.push_back(vector(3.0));
    const double k = static_cast<double>(i);
    state.attributes.push_back({{"mass", 1.5 + k}, {"charge", 0.7 - 2.0 * k}, {"radius", size * (0.6 + 0.2 * k)}});
  }
  state.noise = vec(0.3, -1.1, 0.8);
  return state;
}

LawState pair_at(double r) {
  LawState state = some_particles(2, 1.0, 1);
  const Vec3 along = vec(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0), across = vec(1.0, 2.0, 0.0);
  state.x[1] = state.x[0] + along * r;
  state.v[1] = state.v[0] + along * 0.4 + across;
  return state;
}

void check_conservative(const Law& law, const LawState& state) {
  REQUIRE(law.has_energy());
  const auto forces = forces_of(law, state);
  double largest_force = 1e-3;
  for (const Vec3& f : forces) largest_force = std::fmax(largest_force, largest(f));
  double power = 0.0;
  for (std::size_t i = 0; i < state.x.size(); i++) {
    for (int k = 0; k < 3; k++) {
      const double slope = difference(
          [&](double h) {
            LawState moved = state;
            moved.x[i][k] += h;
            return energy_of(law, moved);
          },
          1e-4);
      CHECK(std::fabs(forces[i][k] + slope) <= 1e-8 * largest_force);
    }
    power += dot(forces[i], state.v[i]);
  }
  const double rate = difference(
      [&](double h) {
        LawState moved = state;
        for (std::size_t i = 0; i < state.x.size(); i++) moved.x[i] += state.v[i] * h;
        return energy_of(law, moved);
      },
      1e-4);
  CHECK(std::fabs(power + rate) <= 3e-8 * largest_force);
}

void check_opposite(const std::vector<Law>& laws, const LawState& state) {
  Vec3 force = zero3(), torque = zero3();
  double largest_force = 0.0;
  const auto forces = forces_of(laws, state);
  for (std::size_t i = 0; i < forces.size(); i++) {
    force += forces[i];
    torque += cross(state.x[i], forces[i]);
    largest_force = std::fmax(largest_force, largest(forces[i]));
  }
  CHECK(largest(force) <= 1e-13 * largest_force);
  CHECK(largest(torque) <= 1e-12 * largest_force);
}

void check_stiffness(const Law& law, double r) {
  const double slope = difference([&](double h) { return tension_at(law, r + h); }, 1e-4);
  const double stiffness = value_of(law, pair_at(r), law.stiffness);
  CHECK(stiffness == Approx(slope).epsilon(1e-8).margin(1e-8));
}

void check_central(const std::vector<Law>& laws, std::initializer_list<double> distances) {
  for (double r : distances) {
    CAPTURE(laws[0].name, r);
    check_conservative(laws[0], pair_at(r));
    check_stiffness(laws[0], r);
    check_opposite(laws, pair_at(r));
  }
}

LawArguments table_arguments(std::vector<double> distances, std::vector<double> potentials,
                             std::vector<double> tensions) {
  LawArguments arguments;
  arguments.distances = std::move(distances);
  arguments.potentials = std::move(potentials);
  arguments.tensions = std::move(tensions);
  return arguments;
}

}  // namespace pantin::testing
