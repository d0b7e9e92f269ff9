#include "laws/derivative.hpp"

#include <map>

namespace pantin {

namespace {

using Kind = Expressions::Kind;
using Node = Expressions::Node;

// Partial derivative of a product by one of its bases.
Expr by_base(Expressions& graph, const Node& node, std::size_t k) {
  auto terms = node.terms;
  const double exponent = terms[k].second;
  terms[k].second -= 1.0;
  return graph.scale(graph.product(terms), exponent);
}

// Whether a function is one of its arguments, chosen by a condition: then which, else nothing to tell.
struct Choice {
  Expr condition, yes, no;
};
bool is_choice(Function f) { return f == Function::minimum || f == Function::maximum || f == Function::select; }
Choice choice(Expressions& graph, const Node& node) {
  const Expr a = node.terms[0].first, b = node.terms[1].first;
  if (node.function == Function::select) return {a, b, node.terms[2].first};
  if (node.function == Function::minimum) return {graph.apply(Function::less, b, a), b, a};
  return {graph.apply(Function::less, a, b), b, a};
}

Expr by_argument_of_power(Expressions& graph, Expr e, Expr a, Expr b, std::size_t k) {
  if (k == 1) return graph.multiply(e, graph.apply(Function::log, a));
  return graph.multiply(b, graph.raise(a, graph.add(b, graph.constant(-1.0))));
}

Expr by_argument_of_atan2(Expressions& graph, Expr y, Expr x, std::size_t k) {
  const Expr r2 = graph.add(graph.multiply(x, x), graph.multiply(y, y));
  return k == 0 ? graph.divide(x, r2) : graph.scale(graph.divide(y, r2), -1.0);
}

// Partial derivative of a function, not a choice, by its argument k.
Expr by_argument(Expressions& graph, Expr e, const Node& node, std::size_t k) {
  const Expr u = node.terms[0].first, one = graph.constant(1.0);
  const auto f = [&](Function function) { return graph.apply(function, u); };
  const auto square = [&](Expr a) { return graph.power(a, 2.0); };
  switch (node.function) {
    case Function::exp: return e;
    case Function::log: return graph.power(u, -1.0);
    case Function::sin: return f(Function::cos);
    case Function::cos: return graph.scale(f(Function::sin), -1.0);
    case Function::tan: return graph.add(one, square(e));
    case Function::asin: return graph.power(graph.subtract(one, square(u)), -0.5);
    case Function::acos: return graph.scale(graph.power(graph.subtract(one, square(u)), -0.5), -1.0);
    case Function::atan: return graph.power(graph.add(one, square(u)), -1.0);
    case Function::atan2: return by_argument_of_atan2(graph, u, node.terms[1].first, k);
    case Function::sinh: return f(Function::cosh);
    case Function::cosh: return f(Function::sinh);
    case Function::tanh: return graph.subtract(one, square(e));
    case Function::power: return by_argument_of_power(graph, e, u, node.terms[1].first, k);
    case Function::abs:
      return graph.select(graph.apply(Function::less, u, graph.constant(0.0)), graph.constant(-1.0), one);
    case Function::spline: return graph.spline(graph.splines()[node.index], u, static_cast<int>(node.value) + 1);
    default: return graph.constant(0.0);  // floor and comparisons: level between jumps
  }
}

std::vector<bool> nodes_of(const Expressions& graph, Expr e) {
  std::vector<bool> needed(static_cast<std::size_t>(e) + 1, false);
  needed.back() = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (const auto& term : graph[static_cast<Expr>(i)].terms) needed[static_cast<std::size_t>(term.first)] = true;
  }
  return needed;
}

Expr node_derivative(Expressions& graph, Expr e, const Input& x, const std::vector<Expr>& known) {
  const Node node = graph[e];
  const auto of = [&](Expr inner) { return known[static_cast<std::size_t>(inner)]; };
  if (node.kind == Kind::constant) return graph.constant(0.0);
  if (node.kind == Kind::input) return graph.constant(graph.inputs()[node.index] == x ? 1.0 : 0.0);
  if (node.kind == Kind::function && is_choice(node.function)) {
    const auto [condition, yes, no] = choice(graph, node);
    return graph.select(condition, of(yes), of(no));
  }
  Expr total = graph.constant(0.0);
  for (std::size_t k = 0; k < node.terms.size(); k++) {
    const auto [inner, factor] = node.terms[k];
    if (graph.is_constant(of(inner), 0.0)) continue;
    const Expr partial = node.kind == Kind::sum       ? graph.constant(factor)
                         : node.kind == Kind::product ? by_base(graph, node, k)
                                                      : by_argument(graph, e, node, k);
    total = graph.add(total, graph.multiply(partial, of(inner)));
  }
  return total;
}

class Reverse {
 public:
  Reverse(Expressions& graph, std::span<const Input> xs) : graph_(graph) {
    for (const Input& x : xs) xs_.push_back(graph.input(x));
  }

  std::vector<Expr> gradient(Expr e) {
    if (const auto found = known_.find(e); found != known_.end()) return found->second;
    const auto needed = nodes_of(graph_, e);
    std::vector<Expressions::Terms> adjoint(needed.size());  // what each node's is the sum of
    adjoint.back() = {{graph_.constant(1.0), 1.0}};
    std::vector<Expressions::Terms> parts(xs_.size());
    for (std::size_t i = needed.size(); i-- > 0;) {
      if (!needed[i]) continue;
      const Expr mine = graph_.sum_of_sums(adjoint[i]);
      adjoint[i] = {{mine, 1.0}};
      if (graph_.is_constant(mine, 0.0)) continue;
      const Node node = graph_[static_cast<Expr>(i)];
      if (node.kind == Kind::function && is_choice(node.function)) {
        add_choice(parts, node, mine);
      } else {
        pass_down(adjoint, node, static_cast<Expr>(i), mine);
      }
    }
    std::vector<Expr> total;
    for (std::size_t k = 0; k < xs_.size(); k++) {
      const auto x = static_cast<std::size_t>(xs_[k]);
      if (x < needed.size() && needed[x]) parts[k].push_back(adjoint[x][0]);
      total.push_back(graph_.sum_of_sums(parts[k]));
    }
    return known_[e] = total;
  }

 private:
  Expressions& graph_;
  std::vector<Expr> xs_;
  std::map<Expr, std::vector<Expr>> known_;

  // The gradients of both are found apart and one is chosen: an adjoint of 0 would not make an infinity 0.
  void add_choice(std::vector<Expressions::Terms>& parts, const Node& node, Expr adjoint) {
    const auto [condition, yes, no] = choice(graph_, node);
    const auto of_yes = gradient(yes), of_no = gradient(no);
    for (std::size_t k = 0; k < parts.size(); k++) {
      const Expr chosen = graph_.select(condition, of_yes[k], of_no[k]);
      parts[k].emplace_back(graph_.multiply(adjoint, chosen), 1.0);
    }
  }

  void pass_down(std::vector<Expressions::Terms>& adjoint, const Node& node, Expr e, Expr mine) {
    for (std::size_t k = 0; k < node.terms.size(); k++) {
      const auto [inner, factor] = node.terms[k];
      if (graph_.is_constant(inner)) continue;
      auto& theirs = adjoint[static_cast<std::size_t>(inner)];
      if (node.kind == Kind::sum) {
        theirs.emplace_back(mine, factor);
      } else {
        const Expr partial = node.kind == Kind::product ? by_base(graph_, node, k) : by_argument(graph_, e, node, k);
        theirs.emplace_back(graph_.multiply(mine, partial), 1.0);
      }
    }
  }
};

}  // namespace

Expr derivative(Expressions& graph, Expr e, const Input& x) {
  const auto needed = nodes_of(graph, e);
  std::vector<Expr> known(needed.size(), no_expression);
  for (std::size_t i = 0; i < needed.size(); i++) {
    if (needed[i]) known[i] = node_derivative(graph, static_cast<Expr>(i), x, known);
  }
  return known.back();
}

std::vector<Expr> gradient(Expressions& graph, Expr e, std::span<const Input> xs) {
  return Reverse(graph, xs).gradient(e);
}

}  // namespace pantin
