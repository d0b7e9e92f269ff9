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
