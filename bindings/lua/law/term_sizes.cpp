#include "lua/law/term_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laws/program.hpp"

namespace pantin::lua {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double undecided = 1e-11;  // of the sizes of what is compared

/// The outputs and all that they are made of, each after its parts.
std::vector<Expr> all_of(const Expressions& graph, std::span<const Expr> outputs) {
  std::vector<bool> needed(graph.size(), false);
  for (Expr e : outputs) needed[static_cast<std::size_t>(e)] = true;
  std::vector<Expr> all;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    all.push_back(static_cast<Expr>(i));
    for (const auto& term : graph[static_cast<Expr>(i)].terms) needed[static_cast<std::size_t>(term.first)] = true;
  }
  std::reverse(all.begin(), all.end());
  return all;
}

/// Sizes of one sample; `value` and `size` by node.
class Sizes {
 public:
  Sizes(const Expressions& graph, std::vector<double>& value, std::vector<double>& size)
      : graph_(graph), value_(value), size_(size) {}

  double of(Expr e) const {
    const Expressions::Node& node = graph_[e];
    const double value = std::fabs(v(e));
    switch (node.kind) {
      case Expressions::Kind::constant:
      case Expressions::Kind::input: return value;
      case Expressions::Kind::sum: {
        double sum = std::fabs(node.value);
        for (const auto& [term, factor] : node.terms) sum += std::fabs(factor) * s(term);
        return sum;
      }
      case Expressions::Kind::product: {
        double product = 1.0;
        for (const auto& [base, exponent] : node.terms)
          product *= exponent >= 1.0
                         ? std::pow(s(base), exponent)
                         : std::pow(std::fabs(v(base)), exponent) * (1.0 + std::fabs(exponent) * relative(base));
        return product;
      }
      case Expressions::Kind::function: break;
    }
    return of_function(node, value);
  }

 private:
  double v(Expr e) const { return value_[static_cast<std::size_t>(e)]; }
  double s(Expr e) const { return size_[static_cast<std::size_t>(e)]; }
  bool is_exact(Expr e) const { return graph_[e].kind <= Expressions::Kind::input; }
  double relative(Expr e) const { return s(e) == 0.0 ? 1.0 : s(e) / std::fabs(v(e)); }

  double of_function(const Expressions::Node& node, double value) const {
    const auto argument = [&](std::size_t i) { return node.terms[i].first; };
    const Expr x = argument(0);
    switch (node.function) {
      case Function::exp:
      case Function::sinh:
      case Function::cosh: return value * (1.0 + s(x));
      case Function::log: return value + relative(x);
      case Function::sin:
      case Function::cos:
      case Function::atan:
      case Function::tanh: return value + s(x);
      case Function::tan: return value + (1.0 + value * value) * s(x);
      case Function::asin:
      case Function::acos: return value + s(x) / std::sqrt(1.0 - v(x) * v(x));
      case Function::atan2: {
        const Expr y = argument(1);
        return value + (s(x) * std::fabs(v(y)) + s(y) * std::fabs(v(x))) / (v(x) * v(x) + v(y) * v(y));
      }
      case Function::power: {
        const Expr exponent = argument(1);
        return value * (1.0 + std::fabs(v(exponent)) * relative(x) + std::fabs(std::log(v(x))) * s(exponent));
      }
      case Function::abs: return s(x);
      case Function::floor: return std::fabs(v(x) - std::nearbyint(v(x))) <= undecided * s(x) ? infinity : value;
      case Function::minimum:
      case Function::maximum: return std::max(s(x), s(argument(1)));
      case Function::less:
      case Function::less_or_equal: {
        const Expr y = argument(1);
        const bool close = std::fabs(v(x) - v(y)) <= undecided * (s(x) + s(y));
        return close && !(is_exact(x) && is_exact(y)) ? infinity : 1.0;
      }
      case Function::select: return std::isinf(s(x)) ? infinity : s(v(x) != 0.0 ? argument(1) : argument(2));
      case Function::spline: break;
    }
    return value + s(x);
  }

  const Expressions& graph_;
  std::vector<double>& value_;
  std::vector<double>& size_;
};

}  // namespace

std::vector<std::vector<double>> run_expressions(const Expressions& graph, std::span<const Expr> outputs, int n,
                                                 const InputValue& value) {
  const Program program = lower(graph, outputs, {.parameters = false});
  Machine machine(program);
  for (std::size_t i = 0; i < program.inputs.size(); i++) {
    const Input& input = program.inputs[i];
    const auto slot = static_cast<int>(i);
    if (input.role == Role::time)
      machine.fill(slot, value(input, 0));
    else
      for (int k = 0; k < n; k++) machine.column(slot)[k] = value(input, k);
  }
  machine.run_uniform();
  machine.run(n);
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < outputs.size(); i++) {
    const double* column = machine.output(static_cast<int>(i));
    values.emplace_back(column, column + n);
  }
  return values;
}

std::vector<std::vector<double>> term_sizes(const Expressions& graph, std::span<const Expr> outputs, int n,
                                            const InputValue& value) {
  const std::vector<Expr> nodes = all_of(graph, outputs);
  const auto values = run_expressions(graph, nodes, n, value);
  std::vector<std::vector<double>> result(outputs.size(), std::vector<double>(static_cast<std::size_t>(n)));
  std::vector<double> of_node(graph.size()), size(graph.size());
  const Sizes sizes(graph, of_node, size);
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); k++) {
    for (std::size_t i = 0; i < nodes.size(); i++) {
      of_node[static_cast<std::size_t>(nodes[i])] = values[i][k];
      size[static_cast<std::size_t>(nodes[i])] = sizes.of(nodes[i]);
    }
    for (std::size_t i = 0; i < outputs.size(); i++) result[i][k] = size[static_cast<std::size_t>(outputs[i])];
  }
  return result;
}

}  // namespace pantin::lua
