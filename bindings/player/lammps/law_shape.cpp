#include "player/lammps/law_shape.hpp"

#include <bit>
#include <cmath>
#include <map>

#include "base/hash.hpp"
#include "player/lammps/system.hpp"

namespace pantin::player {
namespace {

/// Of an expression; numbers count to ten digits, since a factor that is taken out leaves round-off.
class ShapeHash {
 public:
  explicit ShapeHash(const Expressions& graph) : graph_(graph) {}

  std::uint64_t of(Expr e) {
    const auto known = known_.find(e);
    if (known != known_.end()) return known->second;
    const Expressions::Node& node = graph_[e];
    Hash hash;
    hash.add(static_cast<std::uint64_t>(node.kind));
    hash.add(static_cast<std::uint64_t>(node.function));
    hash.add(merged(node.value));
    if (node.kind == Expressions::Kind::input) hash.add(static_cast<std::uint64_t>(graph_.inputs()[node.index].role));
    if (node.kind == Expressions::Kind::function && node.function == Function::spline)
      hash.add(std::bit_cast<std::uint64_t>(graph_.splines()[node.index].get()));
    for (const auto& [term, factor] : node.terms) {
      hash.add(of(term));
      hash.add(merged(factor));
    }
    return known_.emplace(e, hash.value).first->second;
  }

 private:
  const Expressions& graph_;
  std::map<Expr, std::uint64_t> known_;
};

/// Of the first term of a sum; 1 where there is none.
double first_factor(const Expressions& graph, Expr e) {
  const Expressions::Node& node = graph[e];
  return node.kind == Expressions::Kind::sum && !node.terms.empty() ? node.terms[0].second : 1.0;
}

}  // namespace

LawShape shape_of(const Law& law, std::span<const double> parameters,
                  const std::function<double(int, const std::string&)>& attribute) {
  Expressions graph = law.graph;
  Expr force = law.force[0], energy = law.energy;
  const auto put = [&](const Input& input, double value) {
    const Expr by = graph.constant(value);
    force = graph.replaced(force, input, by);
    if (energy != no_expression) energy = graph.replaced(energy, input, by);
  };
  for (const Input& input : inputs_of_law(law)) {
    if (input.role == Role::attribute) put(input, attribute(input.who, input.name));
    for (std::size_t i = 0; input.role == Role::parameter && i < parameters.size(); i++)
      if (law.parameters[i].name == input.name) put(input, parameters[i]);
  }
  const double factor = first_factor(graph, energy == no_expression ? force : energy);
  if (!std::isfinite(1.0 / factor)) return {0, 0.0};
  ShapeHash hashes(graph);
  force = graph.scale(force, 1.0 / factor);
  Hash all;
  all.add(hashes.of(force));
  if (energy != no_expression) {
    energy = graph.scale(energy, 1.0 / factor);
    all.add(hashes.of(energy));
  }
  return {all.value, factor};
}

}  // namespace pantin::player
