#include "laws/expression.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace pantin {

namespace {

bool is_integer(double x) { return x == std::floor(x); }
bool is_even(double x) { return is_integer(x / 2.0); }

}  // namespace

bool Expressions::is_positive(const Node& node) const {
  const auto positive = [this](Expr e) { return (*this)[e].positive; };
  switch (node.kind) {
    case Kind::constant: return node.value > 0.0;
    case Kind::input: return inputs_[node.index].role == Role::distance2;
    case Kind::sum: {
      bool above = node.value > 0.0, below = node.value < 0.0;
      for (const auto& [e, factor] : node.terms) {
        above = above || positive(e);
        below = below || factor < 0.0 || !is_not_negative(e);
      }
      return above && !below;
    }
    case Kind::product:
      return std::all_of(node.terms.begin(), node.terms.end(), [&](auto& t) { return positive(t.first); });
    case Kind::function: break;
  }
  const auto argument = [&](std::size_t i) { return positive(node.terms[i].first); };
  switch (node.function) {
    case Function::exp:
    case Function::cosh: return true;
    case Function::minimum: return argument(0) && argument(1);
    case Function::maximum: return argument(0) || argument(1);
    case Function::select: return argument(1) && argument(2);
    case Function::power: return argument(0);
    default: return false;
  }
}

bool Expressions::is_not_negative(Expr e) const {
  const Node& node = (*this)[e];
  if (node.kind != Kind::product) return node.positive;
  return std::all_of(node.terms.begin(), node.terms.end(),
                     [this](auto& t) { return (*this)[t.first].positive || is_even(t.second); });
}

Expr Expressions::intern(Node node) {
  Key key{static_cast<int>(node.kind), static_cast<int>(node.function), node.value, node.index, node.terms};
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const auto e = static_cast<Expr>(nodes_.size());
  node.positive = is_positive(node);
  nodes_.push_back(std::move(node));
  known_.emplace(std::move(key), e);
  return e;
}

Expr Expressions::constant(double value) {
  const auto [position, fresh] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), static_cast<Expr>(size()));
  if (fresh) {
    Node node;
    node.value = value;
    node.positive = value > 0.0;
    nodes_.push_back(std::move(node));
  }
  return position->second;
}

Expr Expressions::input(const Input& input) {
  const auto found = std::find(inputs_.begin(), inputs_.end(), input);
  Node node;
  node.kind = Kind::input;
  node.index = static_cast<std::uint32_t>(found - inputs_.begin());
  if (found == inputs_.end()) inputs_.push_back(input);
  return intern(std::move(node));
}

Expr Expressions::spline(std::shared_ptr<const Spline> spline, Expr a, int order) {
  if (order > 3) return constant(0.0);
  if (is_constant(a)) return constant(spline->evaluate((*this)[a].value, order));
  const auto found = std::find(splines_.begin(), splines_.end(), spline);
  Node node;
  node.kind = Kind::function;
  node.function = Function::spline;
  node.value = order;
  node.index = static_cast<std::uint32_t>(found - splines_.begin());
  node.terms = {{a, 0.0}};
  if (found == splines_.end()) splines_.push_back(std::move(spline));
  return intern(std::move(node));
}

bool Expressions::is_scaled(Expr e) const {
  const Node& node = (*this)[e];
  return node.kind == Kind::sum && node.value == 0.0 && node.terms.size() == 1;
}

Expr Expressions::finish_sum(double constant_part, const std::map<Expr, double>& terms) {
  Node node;
  node.kind = Kind::sum;
  node.value = constant_part;
  bool is_number = !std::isnan(constant_part);
  for (const auto& [e, factor] : terms) {
    if (factor != 0.0) node.terms.emplace_back(e, factor);
    is_number = is_number && !std::isnan(factor);
  }
  if (!is_number) return constant(std::numeric_limits<double>::quiet_NaN());
  if (node.terms.empty()) return constant(constant_part);
  if (node.terms.size() == 1 && constant_part == 0.0 && node.terms[0].second == 1.0) return node.terms[0].first;
  return intern(std::move(node));
}

Expr Expressions::add_scaled(Expr a, Expr b, double factor) { return sum(0.0, {{a, 1.0}, {b, factor}}); }

Expr Expressions::sum(double constant_part, const Terms& terms) {
  std::map<Expr, double> merged;
  for (const auto& [e, factor] : terms) {
    const Node& node = (*this)[e];
    if (node.kind == Kind::constant) {
      constant_part += factor * node.value;
    } else if (node.kind == Kind::sum && factor != 0.0) {
      constant_part += factor * node.value;
      for (const auto& [inner, inner_factor] : node.terms) merged[inner] += factor * inner_factor;
    } else {
      merged[e] += factor;
    }
  }
  return finish_sum(constant_part, merged);
}

Expr Expressions::sum_of_sums(const Terms& terms) {
  std::map<Expr, double> closed;
  Terms open;
  for (const auto& [e, factor] : terms) {
    if ((*this)[e].kind == Kind::sum && !is_scaled(e)) {
      closed[e] += factor;
    } else {
      open.emplace_back(e, factor);
    }
  }
  if (closed.size() < 2) return sum(0.0, terms);
  const Expr rest = sum(0.0, open);
  if (!is_constant(rest)) closed[rest] += 1.0;
  return finish_sum(is_constant(rest) ? (*this)[rest].value : 0.0, closed);
}

// Puts base^exponent into a product. Exponents add up unless that would turn the square of a root, which is NaN below
// 0, into a whole power.
void Expressions::multiply_in(Powers& powers, Expr base, double exponent) {
  const auto found = powers.find(base);
  if (found == powers.end()) {
    powers[base] = exponent;
    return;
  }
  const double total = found->second + exponent;
  const bool loses_roots = total != 0.0 && is_integer(total) && !is_integer(exponent) && !(*this)[base].positive;
  if (!loses_roots) {
    found->second = total;
    return;
  }
  Node root;
  root.kind = Kind::product;
  root.terms = {{base, exponent}};
  multiply_in(powers, intern(std::move(root)), 1.0);
}

Expr Expressions::finish_product(const Powers& powers) {
  Node node;
  node.kind = Kind::product;
  for (const auto& [base, exponent] : powers) {
    if (exponent != 0.0) node.terms.emplace_back(base, exponent);
  }
  if (node.terms.empty()) return constant(1.0);
  if (node.terms.size() == 1 && node.terms[0].second == 1.0) return node.terms[0].first;
  return intern(std::move(node));
}

Expr Expressions::product(const Terms& terms) {
  Expr result = constant(1.0);
  for (const auto& [base, exponent] : terms) result = multiply(result, power(base, exponent));
  return result;
}

Expr Expressions::multiply(Expr a, Expr b) {
  double factor = 1.0;
  Powers powers;
  for (Expr e : {a, b}) {
    if (is_constant(e)) {
      factor *= (*this)[e].value;
      continue;
    }
    if (is_scaled(e)) {
      const auto [inner, inner_factor] = (*this)[e].terms[0];
      factor *= inner_factor;
      e = inner;
    }
    if ((*this)[e].kind == Kind::product) {
      const Terms terms = (*this)[e].terms;
      for (const auto& [base, exponent] : terms) multiply_in(powers, base, exponent);
    } else {
      multiply_in(powers, e, 1.0);
    }
  }
  return scale(finish_product(powers), factor);
}

// Whether (x y …)^exponent is x^exponent y^exponent …: of factors whose sign is not known there may be one.
bool Expressions::may_split(const Terms& terms, double exponent) const {
  if (is_integer(exponent)) return true;
  return std::count_if(terms.begin(), terms.end(), [this](const auto& term) {
           return !(*this)[term.first].positive && !is_even(term.second);
         }) <= 1;
}

// Puts (base^inner)^outer into a product.
void Expressions::raise_in(Powers& powers, Expr base, double inner, double outer) {
  const double exponent = inner * outer;
  if ((*this)[base].positive || (is_integer(inner) && is_integer(outer))) {
    multiply_in(powers, base, exponent);
  } else if (is_even(inner)) {
    multiply_in(powers, apply(Function::abs, base), exponent);
  } else if (!is_integer(exponent)) {
    multiply_in(powers, base, exponent);
  } else {
    Node root;
    root.kind = Kind::product;
    root.terms = {{base, inner}};
    multiply_in(powers, intern(std::move(root)), outer);
  }
}

Expr Expressions::power(Expr a, double exponent) {
  if (exponent == 0.0) return constant(1.0);
  if (exponent == 1.0) return a;
  if (is_constant(a)) return constant(value_of(Function::power, (*this)[a].value, exponent));
  if (!std::isfinite(exponent)) return apply(Function::power, a, constant(exponent));
  double factor = 1.0;
  if (is_scaled(a) && (is_integer(exponent) || (*this)[a].terms[0].second > 0.0)) {
    factor = value_of(Function::power, (*this)[a].terms[0].second, exponent);
    a = (*this)[a].terms[0].first;
  }
  const Node node = (*this)[a];
  if (node.kind == Kind::function && node.function == Function::exp) {
    return scale(apply(Function::exp, scale(node.terms[0].first, exponent)), factor);
  }
  Powers powers;
  if (node.kind == Kind::product && may_split(node.terms, exponent)) {
    for (const auto& [base, inner] : node.terms) raise_in(powers, base, inner, exponent);
  } else {
    powers[a] = exponent;
  }
  return scale(finish_product(powers), factor);
}

// What a function comes down to, or nothing.
Expr Expressions::simplified(Function f, Expr a, Expr b, Expr c) {
  switch (f) {
    case Function::log: {
      const Node& node = (*this)[a];
      if (node.kind == Kind::function && node.function == Function::exp) return node.terms[0].first;
      if (node.kind != Kind::product || node.terms.size() != 1 || !node.positive) return no_expression;
      const auto [base, exponent] = node.terms[0];
      return scale(apply(Function::log, base), exponent);
    }
    case Function::exp: {
      const Node& node = (*this)[a];
      if (node.kind != Kind::function || node.function != Function::log) return no_expression;
      return (*this)[node.terms[0].first].positive ? node.terms[0].first : no_expression;
    }
    case Function::abs: {
      if ((*this)[a].positive) return a;
      if (!is_scaled(a)) return no_expression;
      const auto [inner, factor] = (*this)[a].terms[0];
      return scale(apply(Function::abs, inner), std::fabs(factor));
    }
    case Function::power:
      return is_constant(b) && std::isfinite((*this)[b].value) ? power(a, (*this)[b].value) : no_expression;
    case Function::minimum:
    case Function::maximum: return a == b ? a : no_expression;
    case Function::less: return a == b ? constant(0.0) : no_expression;
    case Function::select:
      if (is_constant(a)) return (*this)[a].value != 0.0 ? b : c;
      return b == c ? b : no_expression;
    default: return no_expression;
  }
}

Expr Expressions::apply(Function f, Expr a, Expr b, Expr c) {
  assume(f != Function::spline);
  Node node;
  node.kind = Kind::function;
  node.function = f;
  bool all_constant = true;
  double values[3] = {};
  for (Expr e : {a, b, c}) {
    if (e == no_expression) break;
    values[node.terms.size()] = (*this)[e].value;
    all_constant = all_constant && is_constant(e);
    node.terms.emplace_back(e, 0.0);
  }
  if (all_constant) return constant(value_of(f, values[0], values[1], values[2]));
  const Expr simple = simplified(f, a, b, c);
  return simple != no_expression ? simple : intern(std::move(node));
}

}  // namespace pantin
