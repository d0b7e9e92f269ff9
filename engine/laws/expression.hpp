#pragma once
// What a force law is: a graph of sums, products and functions of what a law may see of its particles. Nodes are shared
// and kept in a canonical form, so that equal expressions are one node.
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "laws/spline.hpp"

namespace pantin {

/// What a law may see.
enum class Role : std::uint8_t {
  distance2,          ///< |d|² of a pair [m²], > 0
  approach,           ///< d·u of a pair [m²/s]: its distance times the rate of its distance
  displacement,       ///< component of d, the position of b less that of a [m]
  relative_velocity,  ///< component of u, the velocity of b less that of a [m/s]
  position,           ///< component of the position of particle `who` [m]
  velocity,           ///< component of the velocity of particle `who` [m/s]
  attribute,          ///< `name` of particle `who`
  parameter,          ///< `name` of the law's own
  time,               ///< [s]
  noise,              ///< the number `component` of these particles at this instant: normal, mean 0, variance 1
};

struct Input {
  Role role = Role::distance2;
  std::uint8_t who = 0;        ///< 0: a, 1: b, …
  std::uint8_t component = 0;  ///< 0, 1, 2: x, y, z
  std::string name;
  friend auto operator<=>(const Input&, const Input&) = default;
};

/// Comparisons with NaN are false. `minimum` and `maximum` are the second where it is less (greater), else the first.
enum class Function : std::uint8_t {
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,  ///< of y, x
  sinh,
  cosh,
  tanh,
  power,  ///< the first to the power of the second
  abs,
  floor,
  minimum,
  maximum,
  less,           ///< 1 where the first is below the second, else 0
  less_or_equal,  ///< 1 where the first is not above the second, else 0
  select,         ///< the second where the first is not 0, else the third
  spline,         ///< a Spline or a derivative of it
};

/// A function of numbers, as many of these as it takes; any but `spline`.
double value_of(Function f, double a, double b = 0.0, double c = 0.0);

/// A node of one graph. What is 0 or 1 whatever its finite values are is taken to be so: 0 x, x - x, x / x. Nothing else
/// that is not a number becomes one: the square root of x² is |x|, the square of the root of x is not x.
using Expr = std::int32_t;
inline constexpr Expr no_expression = -1;

class Expressions {
 public:
  enum class Kind : std::uint8_t { constant, input, sum, product, function };
  using Terms = std::vector<std::pair<Expr, double>>;
  struct Node {
    Kind kind = Kind::constant;
    Function function{};
    double value = 0.0;       ///< of a constant; constant part of a sum; order of the derivative of a spline
    std::uint32_t index = 0;  ///< into `inputs()` or `splines()`
    Terms terms;              ///< sum: node, coefficient. product: node, exponent. function: arguments
    bool positive = false;    ///< known to be > 0
  };

  Expr constant(double value);
  Expr input(const Input& input);
  Expr add(Expr a, Expr b) { return add_scaled(a, b, 1.0); }
  Expr subtract(Expr a, Expr b) { return add_scaled(a, b, -1.0); }
  Expr scale(Expr a, double factor) { return add_scaled(constant(0.0), a, factor); }
  Expr multiply(Expr a, Expr b);
  Expr divide(Expr a, Expr b) { return multiply(a, power(b, -1.0)); }
  Expr power(Expr a, double exponent);
  Expr power(Expr a, int exponent) = delete;  ///< would be taken for a node: write 2.0, or `raise`
  Expr raise(Expr a, Expr exponent) { return apply(Function::power, a, exponent); }
  Expr square_root(Expr a) { return power(a, 0.5); }
  /// Does not apply to Function::spline, which has a function of its own.
  Expr apply(Function f, Expr a, Expr b = no_expression, Expr c = no_expression);
  Expr select(Expr condition, Expr yes, Expr no) { return apply(Function::select, condition, yes, no); }
  Expr ceiling(Expr a) { return scale(apply(Function::floor, scale(a, -1.0)), -1.0); }
  /// a - b floor(a / b), Lua's %.
  Expr modulo(Expr a, Expr b) { return subtract(a, multiply(b, apply(Function::floor, divide(a, b)))); }
  /// The derivative of order 0 to 3 of a spline at a, 0 beyond; of order -1 its integral.
  Expr spline(std::shared_ptr<const Spline> spline, Expr a, int order = 0);

  /// sum of coefficient times node, plus a constant
  Expr sum(double constant, const Terms& terms);
  /// The same, but sums among the terms are not opened: what they share with others stays shared.
  Expr sum_of_sums(const Terms& terms);
  /// product of node to the power of exponent
  Expr product(const Terms& terms);

  bool has(Expr e) const { return e >= 0 && static_cast<std::size_t>(e) < nodes_.size(); }
  /// Throws Error where there is none of that number.
  const Node& operator[](Expr e) const {
    require(has(e), "there is no expression ", e, " in this graph");
    return nodes_[static_cast<std::size_t>(e)];
  }
  std::size_t size() const { return nodes_.size(); }
  const std::vector<Input>& inputs() const { return inputs_; }
  const std::vector<std::shared_ptr<const Spline>>& splines() const { return splines_; }
  bool is_constant(Expr e) const { return (*this)[e].kind == Kind::constant; }
  bool is_constant(Expr e, double value) const { return is_constant(e) && (*this)[e].value == value; }
  /// The inputs that some expressions depend on, sorted.
  std::vector<Input> inputs_of(std::span<const Expr> outputs) const;
  bool depends_on(Expr e, Role role) const;

  /// Numbers the nodes that `outputs` are made of anew, by what they are and not by when they were made, and drops the
  /// others.
  void put_in_order(std::span<Expr> outputs);
  /// The expression with one input replaced everywhere.
  Expr replaced(Expr e, const Input& input, Expr by);
  /// Value, given those of `inputs()` in their order; slow, for constants and checks.
  double evaluate(Expr e, std::span<const double> inputs) const;

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  using Powers = std::map<Expr, double>;
  using Key = std::tuple<int, int, double, std::uint32_t, Terms>;

  std::vector<Node> nodes_;
  std::vector<Input> inputs_;
  std::vector<std::shared_ptr<const Spline>> splines_;
  std::map<Key, Expr> known_;
  std::map<std::uint64_t, Expr> constants_;  ///< by bits, so that 0, -0 and NaN are found too

  Expr intern(Node node);
  std::vector<std::uint64_t> structure() const;  ///< (nodes) a hash of what each is
  Expr add_scaled(Expr a, Expr b, double factor);
  Expr finish_sum(double constant, const std::map<Expr, double>& terms);
  Expr finish_product(const Powers& powers);
  Expr simplified(Function f, Expr a, Expr b, Expr c);
  bool is_positive(const Node& node) const;
  bool is_not_negative(Expr e) const;
  bool is_scaled(Expr e) const;
  bool may_split(const Terms& terms, double exponent) const;
  void multiply_in(Powers& powers, Expr base, double exponent);
  void raise_in(Powers& powers, Expr base, double inner, double outer);
};

}  // namespace pantin
