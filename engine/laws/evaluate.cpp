// Going through the nodes of a graph: values, inputs, replacement.
#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "laws/expression.hpp"

namespace pantin {

namespace {

double power_of(double x, double exponent) {
  if (exponent == -1.0) return 1.0 / x;
  if (exponent == 0.5) return std::sqrt(x);
  if (exponent == 1.0) return x;
  if (exponent == 2.0) return x * x;
  return functions::pow(x, exponent);
}

// Which nodes some outputs are made of. Nodes come after those that they are made of.
std::vector<bool> needed_by(const Expressions& graph, std::span<const Expr> outputs) {
  std::vector<bool> needed(graph.size(), false);
  for (Expr e : outputs) needed[static_cast<std::size_t>(e)] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (const auto& [term, factor] : graph[static_cast<Expr>(i)].terms) needed[static_cast<std::size_t>(term)] = true;
  }
  return needed;
}

}  // namespace

double value_of(Function f, double a, double b, double c) {
  switch (f) {
    case Function::exp: return functions::exp(a);
    case Function::log: return functions::log(a);
    case Function::sin: return functions::sin(a);
    case Function::cos: return functions::cos(a);
    case Function::tan: return functions::tan(a);
    case Function::asin: return functions::asin(a);
    case Function::acos: return functions::acos(a);
    case Function::atan: return functions::atan(a);
    case Function::atan2: return functions::atan2(a, b);
    case Function::sinh: return functions::sinh(a);
    case Function::cosh: return functions::cosh(a);
    case Function::tanh: return functions::tanh(a);
    case Function::power: return power_of(a, b);
    case Function::abs: return std::fabs(a);
    case Function::floor: return std::floor(a);
    case Function::minimum: return b < a ? b : a;
    case Function::maximum: return b > a ? b : a;
    case Function::less: return a < b ? 1.0 : 0.0;
    case Function::less_or_equal: return a <= b ? 1.0 : 0.0;
    case Function::select: return a != 0.0 ? b : c;
    case Function::spline: break;
  }
  assume(false);
  return 0.0;
}

std::vector<Input> Expressions::inputs_of(std::span<const Expr> outputs) const {
  std::vector<Input> found;
  const auto needed = needed_by(*this, outputs);
  for (std::size_t i = 0; i < needed.size(); i++) {
    if (needed[i] && nodes_[i].kind == Kind::input) found.push_back(inputs_[nodes_[i].index]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool Expressions::depends_on(Expr e, Role role) const {
  const auto found = inputs_of({&e, 1});
  return std::any_of(found.begin(), found.end(), [&](const Input& input) { return input.role == role; });
}

Expr Expressions::replaced(Expr e, const Input& input, Expr by) {
  const auto needed = needed_by(*this, {&e, 1});
  std::vector<Expr> now(needed.size(), no_expression);
  for (std::size_t i = 0; i < needed.size(); i++) {
    if (!needed[i]) continue;
    Node node = nodes_[i];
    for (auto& term : node.terms) term.first = now[static_cast<std::size_t>(term.first)];
    const auto argument = [&](std::size_t k) { return k < node.terms.size() ? node.terms[k].first : no_expression; };
    switch (node.kind) {
      case Kind::constant: now[i] = static_cast<Expr>(i); break;
      case Kind::input: now[i] = inputs_[node.index] == input ? by : static_cast<Expr>(i); break;
      case Kind::sum: now[i] = sum(node.value, node.terms); break;
      case Kind::product: now[i] = product(node.terms); break;
      case Kind::function:
        now[i] = node.function == Function::spline
                     ? spline(splines_[node.index], argument(0), static_cast<int>(node.value))
                     : apply(node.function, argument(0), argument(1), argument(2));
    }
  }
  return now[static_cast<std::size_t>(e)];
}

double Expressions::evaluate(Expr e, std::span<const double> inputs) const {
  const auto needed = needed_by(*this, {&e, 1});
  std::vector<double> values(needed.size(), 0.0);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(e); i++) {
    if (!needed[i]) continue;
    const Node& node = nodes_[i];
    const auto argument = [&](std::size_t k) {
      return k < node.terms.size() ? values[static_cast<std::size_t>(node.terms[k].first)] : 0.0;
    };
    double value = node.value;
    switch (node.kind) {
      case Kind::constant: break;
      case Kind::input: value = inputs[node.index]; break;
      case Kind::sum:
        for (std::size_t k = 0; k < node.terms.size(); k++) value += node.terms[k].second * argument(k);
        break;
      case Kind::product:
        value = 1.0;
        for (std::size_t k = 0; k < node.terms.size(); k++)
          value *= value_of(Function::power, argument(k), node.terms[k].second);
        break;
      case Kind::function:
        value = node.function == Function::spline
                    ? splines_[node.index]->evaluate(argument(0), static_cast<int>(node.value))
                    : value_of(node.function, argument(0), argument(1), argument(2));
    }
    values[i] = value;
  }
  return values[static_cast<std::size_t>(e)];
}

}  // namespace pantin
