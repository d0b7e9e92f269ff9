#pragma once
// From expressions to instructions. For program.cpp alone.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "laws/program.hpp"

namespace pantin {

using Slot = std::int32_t;

/// Whole powers up to this are chains of products.
inline constexpr double highest_chain = 64.0;

/// One term of a sum: weight or, if it is not -1, a uniform value, times powers of what is not uniform.
struct Monomial {
  double weight = 1.0;
  Slot coefficient = -1;
  std::map<Expr, double> powers;
};

/// What is added to the terms of a sum: a number, or a uniform value.
struct Constant {
  double number = 0.0;
  Slot slot = -1;
  bool is_none() const { return number == 0.0 && slot < 0; }
};

/// Writes instructions, each to a slot of its own, equal ones once.
class Lowering {
 public:
  Lowering(const Expressions& graph, std::span<const Expr> outputs, Uniform uniform) : graph_(graph) {
    find_uniform(uniform);
    count_users(outputs);
    for (const Input& input : graph.inputs_of(outputs)) add_input(input);
    for (Expr e : outputs) outputs_.push_back(value(e));
  }

  const std::vector<Instruction>& code() const { return code_; }
  const std::vector<Input>& inputs() const { return inputs_; }
  const std::vector<Slot>& outputs() const { return outputs_; }
  bool is_uniform(Slot slot) const { return slot_is_uniform_[static_cast<std::size_t>(slot)]; }
  std::size_t slots() const { return slot_is_uniform_.size(); }

 private:
  using Kind = Expressions::Kind;
  using Node = Expressions::Node;
  using Terms = Expressions::Terms;
  using Key = std::tuple<int, int, Slot, Slot, Slot, double, double>;

  const Expressions& graph_;
  std::vector<bool> uniform_;  // nodes
  std::vector<int> users_;     // of nodes: nodes and outputs
  std::vector<Input> inputs_;
  std::vector<Slot> outputs_;
  std::vector<Instruction> code_;
  std::vector<bool> slot_is_uniform_;
  std::map<Expr, Slot> values_;
  std::map<std::pair<Expr, double>, Slot> powers_;
  std::map<Key, Slot> known_;

  bool uniform_node(Expr e) const { return uniform_[static_cast<std::size_t>(e)]; }

  void find_uniform(Uniform uniform) {
    for (std::size_t i = 0; i < graph_.size(); i++) {
      const Node& node = graph_[static_cast<Expr>(i)];
      bool is = std::all_of(node.terms.begin(), node.terms.end(), [&](auto& t) { return uniform_node(t.first); });
      if (node.kind == Kind::input) {
        const Role role = graph_.inputs()[node.index].role;
        is = role == Role::time || (role == Role::parameter && uniform.parameters);
      }
      uniform_.push_back(is);
    }
  }

  void count_users(std::span<const Expr> outputs) {
    users_.assign(graph_.size(), 0);
    for (Expr e : outputs) users_[static_cast<std::size_t>(e)]++;
    for (std::size_t i = users_.size(); i-- > 0;) {
      if (users_[i] == 0) continue;
      for (const auto& term : graph_[static_cast<Expr>(i)].terms) users_[static_cast<std::size_t>(term.first)]++;
    }
  }

  void add_input(const Input& input) {
    for (std::size_t i = 0; i < graph_.size(); i++) {
      const Node& node = graph_[static_cast<Expr>(i)];
      if (node.kind != Kind::input || graph_.inputs()[node.index] != input) continue;
      values_[static_cast<Expr>(i)] = static_cast<Slot>(inputs_.size());
      slot_is_uniform_.push_back(uniform_[i]);
    }
    inputs_.push_back(input);
  }

  Slot emit(Instruction made) {
    const Key key{
        static_cast<int>(made.operation), static_cast<int>(made.function), made.a, made.b, made.c, made.x, made.y};
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    made.to = static_cast<Slot>(slots());
    const auto uniform = [&](Slot s) { return s < 0 || is_uniform(s); };
    const bool index_in_c = made.operation == Operation::function && made.function == Function::spline;
    slot_is_uniform_.push_back(uniform(made.a) && uniform(made.b) && (index_in_c || uniform(made.c)));
    code_.push_back(made);
    return known_[key] = made.to;
  }
  Slot emit(Operation operation, Slot a, Slot b = -1, Slot c = -1, double x = 0.0, double y = 0.0) {
    const bool symmetric = operation == Operation::multiply || operation == Operation::add ||
                           operation == Operation::multiply_add || operation == Operation::multiply_add_number;
    if (operation == Operation::multiply && a == b) return emit(Operation::square, a);
    if (symmetric && b < a) std::swap(a, b);
    return emit({operation, Function{}, -1, a, b, c, x, y});
  }

  Slot number(double x) {
    // -0 and NaN are no keys of a map.
    if (x == 0.0 && std::signbit(x)) return emit(Operation::multiply_number, number(-1.0), -1, -1, 0.0);
    if (std::isnan(x)) return emit(Operation::subtract, number(HUGE_VAL), number(HUGE_VAL));
    return emit(Operation::set, -1, -1, -1, x);
  }

  Slot value(Expr e) {
    if (const auto found = values_.find(e); found != values_.end()) return found->second;
    const Node& node = graph_[e];
    Slot slot = -1;
    switch (node.kind) {
      case Kind::constant: slot = number(node.value); break;
      case Kind::input: break;
      case Kind::sum: slot = sum(node, uniform_node(e)); break;
      case Kind::product: slot = product(1.0, node.terms, uniform_node(e)); break;
      case Kind::function: slot = function(node); break;
    }
    return values_[e] = slot;
  }

  Slot function(const Node& node) {
    Slot arguments[3] = {-1, -1, -1};
    for (std::size_t k = 0; k < node.terms.size(); k++) arguments[k] = value(node.terms[k].first);
    if (node.function == Function::spline) arguments[2] = static_cast<Slot>(node.index);
    return emit({Operation::function, node.function, -1, arguments[0], arguments[1], arguments[2], node.value, 0.0});
  }

  Slot function(Function f, Slot a, Slot b) { return emit({Operation::function, f, -1, a, b, -1, 0.0, 0.0}); }

  bool has_power(Expr base, double exponent) const { return powers_.contains({base, exponent}); }

  Slot power(Expr base, double exponent) {
    if (exponent == 1.0) return value(base);
    if (exponent == 0.0) return number(1.0);
    if (const auto found = powers_.find({base, exponent}); found != powers_.end()) return found->second;
    const Slot made = new_power(base, exponent);
    return powers_[{base, exponent}] = made;
  }

  // At 0 a root and its reciprocal make NaN, so they are made of each other only where the base is positive.
  Slot new_power(Expr base, double exponent) {
    const bool positive = graph_[base].positive;
    if (exponent == 0.5) {
      return has_power(base, -0.5) && positive ? emit(Operation::multiply, value(base), power(base, -0.5))
                                               : emit(Operation::square_root, value(base));
    }
    if (exponent == -0.5) {
      return has_power(base, -1.0) && has_power(base, 0.5) && positive
                 ? emit(Operation::multiply, power(base, 0.5), power(base, -1.0))
                 : emit(Operation::reciprocal, power(base, 0.5));
    }
    if (exponent == -1.0) {
      return has_power(base, -0.5) && positive ? emit(Operation::square, power(base, -0.5))
                                               : emit(Operation::reciprocal, value(base));
    }
    if (std::fabs(exponent) > highest_chain || 2.0 * exponent != std::floor(2.0 * exponent)) {
      return function(Function::power, value(base), number(exponent));
    }
    const bool whole = exponent == std::floor(exponent);
    if (whole && std::fmod(exponent, 2.0) == 0.0) return emit(Operation::square, power(base, exponent / 2.0));
    const double first = std::copysign(whole ? 1.0 : 0.5, exponent);
    const Slot low = power(base, first);
    return emit(Operation::multiply, power(base, exponent - first), low);
  }

  // The product as one of two slots, so that a sum can take the last multiplication along. The second may be -1.
  std::pair<Slot, Slot> two_factors(const std::map<Expr, double>& powers) {
    if (powers.size() == 1) {
      const auto [base, exponent] = *powers.begin();
      const bool square = std::fmod(exponent, 2.0) == 0.0 && std::fabs(exponent) <= highest_chain;
      if (!square || has_power(base, exponent)) return {power(base, exponent), -1};
      const Slot half = power(base, exponent / 2.0);
      return {half, half};
    }
    Slot made = -1, last = -1;
    for (const auto& [base, exponent] : powers) {
      if (last >= 0) made = made < 0 ? last : emit(Operation::multiply, made, last);
      last = power(base, exponent);
    }
    return {made, last};
  }
  Slot product(const std::map<Expr, double>& powers) {
    const auto [a, b] = two_factors(powers);
    return b < 0 ? a : emit(Operation::multiply, a, b);
  }
  // weight times uniform factors times others. A sum among the others takes the former into its own coefficients.
  Slot product(double weight, const std::map<Expr, double>& uniform, std::map<Expr, double> other) {
    const auto absorbing = std::find_if(other.begin(), other.end(), [&](const auto& factor) {
      const auto& [base, exponent] = factor;
      return exponent == 1.0 && graph_[base].kind == Kind::sum && users_[static_cast<std::size_t>(base)] == 1;
    });
    if (absorbing != other.end() && (weight != 1.0 || !uniform.empty())) {
      const Slot inner = sum(graph_[absorbing->first], false, Monomial{weight, -1, uniform});
      other.erase(absorbing);
      return other.empty() ? inner : emit(Operation::multiply, product(other), inner);
    }
    const Slot value = product(other);
    if (uniform.empty()) return weight == 1.0 ? value : emit(Operation::multiply_number, value, -1, -1, weight);
    Slot coefficient = product(uniform);
    if (weight != 1.0) coefficient = emit(Operation::multiply_number, coefficient, -1, -1, weight);
    return emit(Operation::multiply, value, coefficient);
  }
  Slot product(double weight, const Terms& factors, bool all_uniform) {
    std::map<Expr, double> uniform, other;
    for (const auto& [base, exponent] : factors)
      (uniform_node(base) && !all_uniform ? uniform : other)[base] = exponent;
    return product(weight, uniform, std::move(other));
  }

  static Terms factors_of(const Expressions& graph, Expr e) {
    return graph[e].kind == Kind::product ? graph[e].terms : Terms{{e, 1.0}};
  }

  static void put(std::map<Expr, double>& powers, Expr base, double exponent) {
    if ((powers[base] += exponent) == 0.0) powers.erase(base);
  }

  // A sum, all of it times a weight and uniform factors.
  Slot sum(const Node& node, bool all_uniform, const Monomial& times = {}) {
    if (node.terms.size() == 1 && node.value == 0.0 && times.powers.empty()) {
      return product(node.terms[0].second * times.weight, factors_of(graph_, node.terms[0].first), all_uniform);
    }
    // Terms with the same powers of what is not uniform are one monomial; its coefficient is a sum of its own.
    std::map<std::map<Expr, double>, std::vector<Monomial>> alike;
    for (const auto& [e, weight] : node.terms) {
      Monomial uniform = times;
      std::map<Expr, double> other;
      uniform.weight *= weight;
      for (const auto& [base, exponent] : factors_of(graph_, e)) {
        put(uniform_node(base) && !all_uniform ? uniform.powers : other, base, exponent);
      }
      alike[other].push_back(std::move(uniform));
    }
    Constant constant{node.value * times.weight, -1};
    if (node.value != 0.0 && !times.powers.empty()) {
      alike[{}].push_back({constant.number, -1, times.powers});
      constant.number = 0.0;
    }
    if (const auto found = alike.find({}); found != alike.end()) {
      constant.slot = sum(constant, std::move(found->second));
      alike.erase(found);
    }
    std::vector<Monomial> monomials;
    for (auto& [powers, coefficients] : alike) {
      Monomial made{coefficients[0].weight, -1, powers};
      if (coefficients.size() > 1 || !coefficients[0].powers.empty()) {
        made = {1.0, sum(Constant{}, std::move(coefficients)), powers};
      }
      monomials.push_back(std::move(made));
    }
    return sum(constant, std::move(monomials));
  }

  // The power that most terms share: base, and whether the exponent is positive; in at least two terms.
  static std::pair<Expr, bool> most_shared(const std::vector<Monomial>& monomials) {
    std::map<std::pair<Expr, bool>, int> count;
    for (const Monomial& m : monomials) {
      for (const auto& [base, exponent] : m.powers) count[{base, exponent > 0.0}]++;
    }
    const auto best =
        std::max_element(count.begin(), count.end(), [](auto& p, auto& q) { return p.second < q.second; });
    return best == count.end() || best->second < 2 ? std::pair{no_expression, false} : best->first;
  }

  // Horner: what most terms share is taken out, and again from what is left.
  Slot sum(Constant constant, std::vector<Monomial> monomials) {
    std::erase_if(monomials, [&](const Monomial& m) {
      if (m.powers.empty() && m.coefficient < 0) constant.number += m.weight;
      return m.powers.empty() && m.coefficient < 0;
    });
    const auto [base, rising] = most_shared(monomials);
    if (base == no_expression) return plain_sum(constant, std::move(monomials));
    double exponent = 0.0;
    std::vector<Monomial> with, without;
    for (Monomial& m : monomials) {
      const auto found = m.powers.find(base);
      const bool has = found != m.powers.end() && (found->second > 0.0) == rising;
      if (has && (exponent == 0.0 || std::fabs(found->second) < std::fabs(exponent))) exponent = found->second;
      (has ? with : without).push_back(std::move(m));
    }
    const Slot inner = without_base(with, base, exponent);
    const Slot outer = power(base, exponent);
    if (!without.empty()) return emit(Operation::multiply_add, outer, inner, sum(constant, std::move(without)));
    if (constant.slot >= 0) return emit(Operation::multiply_add, outer, inner, constant.slot);
    if (constant.number != 0.0) return emit(Operation::multiply_add_number, outer, inner, -1, constant.number);
    return emit(Operation::multiply, outer, inner);
  }

  // The terms with the power taken out of each.
  Slot without_base(std::vector<Monomial>& monomials, Expr base, double exponent) {
    Constant constant;
    std::vector<Monomial> left;
    for (Monomial& m : monomials) {
      put(m.powers, base, -exponent);
      if (m.powers.empty() && m.coefficient >= 0) {
        constant.slot = m.coefficient;
      } else {
        left.push_back(std::move(m));
      }
    }
    return sum(constant, std::move(left));
  }

  Slot plain_sum(Constant constant, std::vector<Monomial> monomials) {
    if (monomials.empty()) return constant.slot >= 0 ? constant.slot : number(constant.number);
    const auto easy_start = std::find_if(monomials.begin(), monomials.end(), [](const Monomial& m) {
      return m.weight == 1.0;  // the others are then added without a multiplication of the first
    });
    if (constant.is_none() && easy_start != monomials.end()) std::rotate(monomials.begin(), easy_start, easy_start + 1);
    Slot total = -1;
    for (const Monomial& m : monomials) { total = total < 0 ? first_term(constant, m) : next_term(total, m); }
    return total;
  }

  Slot first_term(Constant constant, const Monomial& m) {
    if (constant.slot >= 0) return next_term(constant.slot, m);
    const double number = constant.number;
    if (m.coefficient < 0 && m.weight != 1.0) {
      const Slot value = product(m.powers);
      return number == 0.0 ? emit(Operation::multiply_number, value, -1, -1, m.weight)
                           : emit(Operation::multiply_number_add_number, value, -1, -1, m.weight, number);
    }
    auto [a, b] = two_factors(m.powers);
    if (m.coefficient >= 0) {
      if (b >= 0) a = emit(Operation::multiply, a, b);
      b = m.coefficient;
    }
    if (b < 0) return number == 0.0 ? a : emit(Operation::add_number, a, -1, -1, number);
    return number == 0.0 ? emit(Operation::multiply, a, b) : emit(Operation::multiply_add_number, a, b, -1, number);
  }

  Slot next_term(Slot total, const Monomial& m) {
    if (m.coefficient >= 0) return emit(Operation::multiply_add, product(m.powers), m.coefficient, total);
    if (m.weight == -1.0) return emit(Operation::subtract, total, product(m.powers));
    if (m.weight != 1.0) return emit(Operation::multiply_number_add, product(m.powers), total, -1, m.weight);
    const auto [a, b] = two_factors(m.powers);
    return b < 0 ? emit(Operation::add, total, a) : emit(Operation::multiply_add, a, b, total);
  }
};

}  // namespace pantin
