#pragma once
// What a force law is: a graph of sums, products and functions of what a law may see of its particles. Nodes are shared
// and kept in a canonical form, so that equal expressions are one node.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace pantin {

/// What a law may see.
enum class Role : std::uint8_t {
  distance2,          ///< |d|² of a pair [m²], > 0
  approach,           ///< d·u of a pair [m²/s]: its distance times the rate of its distance
  displacement,       ///< component of d, the place of b less that of a [m]
  relative_velocity,  ///< component of u, the velocity of b less that of a [m/s]
  place,              ///< component of the place of particle `who` [m]
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

enum class Function : std::uint8_t {
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  tanh,
  abs,
  floor,
  minimum,
  maximum,
  less,    ///< 1 where the first is below the second, else 0
  select,  ///< the second where the first is not 0, else the third
};

/// A node of one graph.
using Expr = std::int32_t;
inline constexpr Expr no_expression = -1;

class Expressions {
 public:
  enum class Kind : std::uint8_t { constant, input, sum, product, function };
  struct Node {
    Kind kind = Kind::constant;
    Function function{};
    double value = 0.0;  ///< of a constant; constant part of a sum
    std::vector<std::pair<Expr, double>>
        terms;                ///< sum: node, coefficient. product: node, exponent. function: arguments
    std::uint32_t input = 0;  ///< index into `inputs()`
    bool positive = false;    ///< known to be > 0
  };

  Expr constant(double value);
  Expr input(const Input& input);
  Expr add(Expr a, Expr b);
  Expr subtract(Expr a, Expr b);
  Expr scale(Expr a, double factor);
  Expr multiply(Expr a, Expr b);
  Expr divide(Expr a, Expr b);
  Expr power(Expr a, double exponent);
  Expr power(Expr a, Expr exponent);
  Expr apply(Function f, Expr a, Expr b = no_expression, Expr c = no_expression);
  Expr select(Expr condition, Expr yes, Expr no) { return apply(Function::select, condition, yes, no); }
  Expr square_root(Expr a) { return power(a, 0.5); }

  const Node& operator[](Expr e) const { return nodes_[static_cast<std::size_t>(e)]; }
  std::size_t size() const { return nodes_.size(); }
  const std::vector<Input>& inputs() const { return inputs_; }
  bool is_constant(Expr e) const { return (*this)[e].kind == Kind::constant; }
  bool is_constant(Expr e, double value) const { return is_constant(e) && (*this)[e].value == value; }
  /// The inputs that an expression depends on, sorted.
  std::vector<Input> inputs_of(std::span<const Expr> outputs) const;

  /// The expression with one input replaced everywhere.
  Expr replaced(Expr e, const Input& input, Expr by);
  /// Value, given those of `inputs()` in their order; slow, for constants and checks.
  double evaluate(Expr e, std::span<const double> inputs) const;

 private:
  std::vector<Node> nodes_;
  std::vector<Input> inputs_;
  std::map<std::tuple<int, int, double, std::uint32_t, std::vector<std::pair<Expr, double>>>, Expr> known_;
};

}  // namespace pantin
