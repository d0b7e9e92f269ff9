#pragma once
// Laws tried on a few particles, by slow evaluation of their expressions.
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/lanes.hpp"
#include "laws/law.hpp"

namespace pantin::testing {

struct LawState {
  std::vector<Vec3> x, v;
  std::vector<std::map<std::string, double>> attributes;
  std::map<std::string, double> parameters;  ///< instead of those of the law
  double time = 0.0;
  Vec3 noise = zero3();
};

inline double value_of(const Law& law, const LawState& state, const Input& input) {
  const auto at = [&](const std::vector<Vec3>& vectors, std::size_t who) { return vectors.at(who)[input.component]; };
  const auto parameter = [&] {
    if (const auto found = state.parameters.find(input.name); found != state.parameters.end()) return found->second;
    for (const Parameter& p : law.parameters) {
      if (p.name == input.name) return p.value;
    }
    return std::nan("");
  };
  switch (input.role) {
    case Role::distance2: return norm2(state.x.at(1) - state.x.at(0));
    case Role::approach: return dot(state.x.at(1) - state.x.at(0), state.v.at(1) - state.v.at(0));
    case Role::displacement: return at(state.x, 1) - at(state.x, 0);
    case Role::relative_velocity: return at(state.v, 1) - at(state.v, 0);
    case Role::position: return at(state.x, input.who);
    case Role::velocity: return at(state.v, input.who);
    case Role::attribute: return state.attributes.at(input.who).at(input.name);
    case Role::parameter: return parameter();
    case Role::time: return state.time;
    case Role::noise: return state.noise[input.component];
  }
  return 0.0;
}

inline double value_of(const Law& law, const LawState& state, Expr e) {
  // Only what the expression depends on has a value here.
  const auto wanted = law.graph.inputs_of({&e, 1});
  std::vector<double> values;
  for (const Input& input : law.graph.inputs()) {
    const bool is_wanted = std::find(wanted.begin(), wanted.end(), input) != wanted.end();
    values.push_back(is_wanted ? value_of(law, state, input) : std::nan(""));
  }
  return law.graph.evaluate(e, values);
}

inline double energy_of(const Law& law, const LawState& state) {
  return law.has_energy() ? value_of(law, state, law.energy) : 0.0;
}

/// On each particle [N].
inline std::vector<Vec3> forces_of(const Law& law, const LawState& state) {
  const auto output = [&](std::size_t k) { return value_of(law, state, law.force.at(k)); };
  if (law.kind == LawKind::central) {
    const Vec3 on_a = (state.x[1] - state.x[0]) * output(0);
    return {on_a, law.one_sided ? zero3() : -on_a};
  }
  std::vector<Vec3> forces;
  for (std::size_t k = 0; k + 2 < law.force.size(); k += 3) {
    forces.push_back(vec(output(k), output(k + 1), output(k + 2)));
  }
  if (law.kind == LawKind::pair) forces.push_back(law.one_sided ? zero3() : -forces[0]);
  return forces;
}

inline std::vector<Vec3> forces_of(const std::vector<Law>& laws, const LawState& state) {
  std::vector<Vec3> total(state.x.size(), zero3());
  for (const Law& law : laws) {
    const auto forces = forces_of(law, state);
    for (std::size_t i = 0; i < total.size(); i++) total[i] += forces[i];
  }
  return total;
}

inline double tension_of(const Law& law, const LawState& state) {
  return value_of(law, state, law.force.at(0)) * norm(state.x[1] - state.x[0]);
}

/// Sixth-order central difference.
inline double difference(const std::function<double(double)>& f, double h) {
  return (45.0 * (f(h) - f(-h)) - 9.0 * (f(2 * h) - f(-2 * h)) + f(3 * h) - f(-3 * h)) / (60.0 * h);
}

}  // namespace pantin::testing
