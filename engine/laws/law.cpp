#include "laws/law.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "laws/derivative.hpp"
#include "laws/velocity_slopes.hpp"

namespace pantin {

namespace {

const Input distance2{Role::distance2, 0, 0, {}}, approach{Role::approach, 0, 0, {}};

std::string name_of(const Input& input) {
  static constexpr const char* axis[] = {"x", "y", "z"};
  const char* component = axis[input.component % 3];
  const std::string particle = text("particle ", input.who + 1);
  switch (input.role) {
    case Role::distance2: return "the distance of a pair";
    case Role::approach: return "the rate of the distance of a pair";
    case Role::displacement: return text("the position of b relative to a (", component, ")");
    case Role::relative_velocity: return text("the velocity of b relative to a (", component, ")");
    case Role::position: return text("the position of ", particle, " (", component, ")");
    case Role::velocity: return text("the velocity of ", particle, " (", component, ")");
    case Role::attribute: return text("the ", input.name, " of ", particle);
    case Role::parameter: return text("the parameter ", input.name);
    case Role::time: return "time";
    case Role::noise: return "noise";
  }
  return {};
}

struct Sort {
  const char* name;
  LawKind kind;
  int count;
  std::vector<Role> seen;  // beside attributes, parameters and time
};

constexpr int most_excluded = 8;  // more are looked for in a time that grows with their power

// A law without its expressions, when these depend on nothing that they must not.
Law start(const LawDef& def, const Sort& sort, const Expressions& graph, std::span<const Expr> expressions) {
  for (Expr e : expressions) {
    require(graph.has(e), def.name, ": there is no expression ", e, " in its graph");
    require(!graph.is_constant(e) || std::isfinite(graph[e].value), def.name, ": ", sort.name,
            " must be a finite number, and this is always ", graph[e].value);
  }
  require(def.cutoff > 0.0, def.name, ": the cutoff must be > 0 m, got ", def.cutoff);
  require(def.exclude >= 0 && def.exclude <= most_excluded, def.name,
          ": exclude must be a number of connections from 0 to ", most_excluded, ", got ", def.exclude);
  Law law;
  law.name = def.name;
  law.kind = sort.kind;
  law.count = sort.count;
  law.cutoff = def.cutoff;
  law.touching = def.touching;
  law.one_sided = def.one_sided;
  law.exclude = def.exclude;
  law.parameters = def.parameters;
  for (const Input& input : graph.inputs_of(expressions)) {
    const Role role = input.role;
    const bool common = role == Role::attribute || role == Role::parameter || role == Role::time;
    const bool seen = common || std::find(sort.seen.begin(), sort.seen.end(), role) != sort.seen.end();
    require(seen && input.who < sort.count, def.name, ": ", sort.name, " cannot depend on ", name_of(input));
    const auto named = [&](const Parameter& parameter) { return parameter.name == input.name; };
    require(role != Role::parameter || std::any_of(law.parameters.begin(), law.parameters.end(), named), def.name,
            ": there is no parameter \"", input.name, "\"");
    law.velocity_dependent =
        law.velocity_dependent || role == Role::approach || role == Role::relative_velocity || role == Role::velocity;
    law.timed = law.timed || role == Role::time || role == Role::noise;
  }
  law.graph = graph;
  return law;
}

/// The same bits from every compiler.
Law in_order(Law law) {
  std::vector<Expr> outputs = law.force;
  outputs.insert(outputs.end(), {law.energy, law.stiffness});
  law.graph.put_in_order(outputs);
  law.stiffness = outputs.back();
  law.energy = outputs[law.force.size()];
  outputs.resize(law.force.size());
  law.force = std::move(outputs);
  return law;
}

void require_components(const LawDef& def, std::span<const Expr> force) {
  require(force.size() == 3, def.name, ": a force has 3 components, got ", force.size());
}

std::vector<Input> positions(int who) {
  std::vector<Input> found;
  for (std::uint8_t k = 0; k < 3; k++) found.push_back({Role::position, static_cast<std::uint8_t>(who), k, {}});
  return found;
}

void set_force_from_potential(Law& law, Expr potential) {
  std::vector<Input> xs;
  for (int who = 0; who < law.count; who++) {
    for (const Input& x : positions(who)) xs.push_back(x);
  }
  law.force = gradient(law.graph, law.graph.scale(potential, -1.0), xs);
  if (!law.timed) law.energy = potential;
}

}  // namespace

Expr rate_of_distance(Expressions& graph) {
  return graph.multiply(graph.input(approach), graph.power(graph.input(distance2), -0.5));
}

Law central_potential(const LawDef& def, const Expressions& graph, Expr potential) {
  Law law = start(def, {"a potential of a pair", LawKind::central, 2, {Role::distance2}}, graph, {&potential, 1});
  Expressions& g = law.graph;
  const Expr r2 = g.input(distance2);
  const Expr slope = derivative(g, potential, distance2), second = derivative(g, slope, distance2);
  law.force = {g.scale(slope, 2.0)};
  law.stiffness = g.add(g.scale(slope, 2.0), g.scale(g.multiply(r2, second), 4.0));
  if (law.timed || law.one_sided) return in_order(std::move(law));
  law.energy = potential;
  if (def.shift && def.cutoff < std::numeric_limits<double>::infinity()) {
    law.energy = g.subtract(potential, g.replaced(potential, distance2, g.constant(def.cutoff * def.cutoff)));
  }
  return in_order(std::move(law));
}

Law central_tension(const LawDef& def, const Expressions& graph, Expr tension) {
  const Sort sort{"a tension", LawKind::central, 2, {Role::distance2, Role::approach, Role::noise}};
  Law law = start(def, sort, graph, {&tension, 1});
  Expressions& g = law.graph;
  const Expr r = g.square_root(g.input(distance2));
  law.force = {g.divide(tension, r)};
  // The rate of distance is kept while the distance varies: it takes the place of approach.
  const Input rate{Role::approach, 0, 0, "rate"};
  const Expr of_rate = g.replaced(tension, approach, g.multiply(r, g.input(rate)));
  const Expr by_distance = g.scale(g.multiply(r, derivative(g, of_rate, distance2)), 2.0);
  law.stiffness = g.replaced(by_distance, rate, rate_of_distance(g));
  return in_order(std::move(law));
}

Law pair_force(const LawDef& def, const Expressions& graph, std::span<const Expr> force_on_a) {
  require_components(def, force_on_a);
  const Sort sort{"the force of a pair",
                  LawKind::pair,
                  2,
                  {Role::distance2, Role::approach, Role::displacement, Role::relative_velocity, Role::noise}};
  Law law = start(def, sort, graph, force_on_a);
  law.force.assign(force_on_a.begin(), force_on_a.end());
  law.workless = law.velocity_dependent && is_workless(law);
  return in_order(std::move(law));
}

Law point_potential(const LawDef& def, const Expressions& graph, Expr potential) {
  Law law = start(def, {"a potential of a particle", LawKind::point, 1, {Role::position}}, graph, {&potential, 1});
  set_force_from_potential(law, potential);
  return in_order(std::move(law));
}

Law point_force(const LawDef& def, const Expressions& graph, std::span<const Expr> force) {
  require_components(def, force);
  const Sort sort{"the force on a particle", LawKind::point, 1, {Role::position, Role::velocity, Role::noise}};
  Law law = start(def, sort, graph, force);
  law.force.assign(force.begin(), force.end());
  law.workless = law.velocity_dependent && is_workless(law);
  return in_order(std::move(law));
}

Law many_potential(const LawDef& def, int count, const Expressions& graph, Expr potential) {
  constexpr int most = 4;
  require(count >= 1 && count <= most, def.name, ": a law is of 1 to ", most, " particles, got ", count);
  const Sort sort{"a potential of several particles", LawKind::many, count, {Role::position}};
  Law law = start(def, sort, graph, {&potential, 1});
  set_force_from_potential(law, potential);
  return in_order(std::move(law));
}

}  // namespace pantin
