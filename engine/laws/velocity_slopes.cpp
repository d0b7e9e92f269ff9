#include "laws/velocity_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/lanes.hpp"
#include "base/random.hpp"
#include "laws/derivative.hpp"

namespace pantin {

namespace {

const Input approach_in{Role::approach, 0, 0, {}};

Input component(Role role, int k) { return {role, 0, static_cast<std::uint8_t>(k), {}}; }

bool is_velocity(Role role) {
  return role == Role::approach || role == Role::relative_velocity || role == Role::velocity;
}

/// What a law may see, with positions and velocities that agree with each other.
struct Sample {
  std::vector<double> values;  // (inputs)
  Vec3 u;                      // [m/s]
};

Sample sample(const Law& law, Random& random, double speed) {
  const auto vector = [&] {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return vec(2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * z - 1.0);
  };
  const Vec3 d = vector(), x = vector();
  Sample s{{}, vector() * speed};
  for (const Input& input : law.graph.inputs()) {
    switch (input.role) {
      case Role::distance2: s.values.push_back(norm2(d)); break;
      case Role::approach: s.values.push_back(dot(d, s.u)); break;
      case Role::displacement: s.values.push_back(d[input.component]); break;
      case Role::position: s.values.push_back(x[input.component]); break;
      case Role::relative_velocity:
      case Role::velocity: s.values.push_back(s.u[input.component]); break;
      case Role::parameter: {
        const auto named = [&](const Parameter& p) { return p.name == input.name; };
        const double given = std::find_if(law.parameters.begin(), law.parameters.end(), named)->value;
        s.values.push_back(std::isfinite(given) && given != 0.0 ? given : 0.5 + random.uniform());
        break;
      }
      default: s.values.push_back(0.5 + random.uniform());
    }
  }
  return s;
}

/// Whether some function of velocities may leap, which its derivative does not tell.
bool may_leap(const Expressions& g) {
  const auto by_velocity = [&](const auto& term) {
    return g.depends_on(term.first, Role::approach) || g.depends_on(term.first, Role::relative_velocity) ||
           g.depends_on(term.first, Role::velocity);
  };
  for (std::size_t i = 0; i < g.size(); i++) {
    const Expressions::Node& node = g[static_cast<Expr>(i)];
    const bool leaps = node.kind == Expressions::Kind::function &&
                       (node.function == Function::select || node.function == Function::less ||
                        node.function == Function::less_or_equal || node.function == Function::floor);
    if (leaps && std::any_of(node.terms.begin(), node.terms.end(), by_velocity)) return true;
  }
  return false;
}

}  // namespace

std::shared_ptr<const Law> with_velocity_slopes(const Law& law) {
  auto sloped = std::make_shared<Law>(law);
  if (law.called) return sloped;
  Expressions& g = sloped->graph;
  sloped->energy = sloped->stiffness = no_expression;
  if (law.kind == LawKind::central) {
    sloped->force.push_back(derivative(g, law.force[0], approach_in));
  } else {
    const Role role = law.kind == LawKind::point ? Role::velocity : Role::relative_velocity;
    for (int by = 0; by < 3; by++)
      for (std::size_t of = 0; of < 3; of++) {
        Expr slope = derivative(g, law.force[of], component(role, by));
        if (law.kind == LawKind::pair)
          slope = g.add(
              slope, g.multiply(derivative(g, law.force[of], approach_in), g.input(component(Role::displacement, by))));
        sloped->force.push_back(slope);
      }
  }
  g.put_in_order(sloped->force);
  return sloped;
}

bool is_linear_in_velocity(const Law& sloped) {
  if (sloped.called || may_leap(sloped.graph)) return false;
  const std::size_t forces = sloped.kind == LawKind::central ? 1 : 3;
  const std::vector<Input> inputs = sloped.graph.inputs_of(std::span(sloped.force).subspan(forces));
  return std::none_of(inputs.begin(), inputs.end(), [](const Input& input) { return is_velocity(input.role); });
}

bool is_workless(const Law& law) {
  if (law.called || (law.kind != LawKind::point && law.kind != LawKind::pair)) return false;
  Random random{1};
  constexpr double speeds[] = {1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1000.0};
  for (int k = 0; k < 63; k++) {
    const Sample s = sample(law, random, speeds[k % 7]);
    std::vector<double> still = s.values;
    for (std::size_t i = 0; i < still.size(); i++)
      if (is_velocity(law.graph.inputs()[i].role)) still[i] = 0.0;
    double power = 0.0, size = 0.0;
    for (int c = 0; c < 3; c++) {
      const Expr force = law.force[static_cast<std::size_t>(c)];
      const double moved = law.graph.evaluate(force, s.values), rest = law.graph.evaluate(force, still);
      power += (moved - rest) * s.u[c];
      size += (std::fabs(moved) + std::fabs(rest)) * std::fabs(s.u[c]);
    }
    if (!(std::fabs(power) <= 1e-12 * size)) return false;
  }
  return true;
}

}  // namespace pantin
