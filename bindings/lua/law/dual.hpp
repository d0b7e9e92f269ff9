#pragma once
// A number with its derivatives: how the force of a potential that cannot be traced is had, exact to round-off.
#include <array>
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <string>

#include "laws/expression.hpp"
#include "lua/value/values.hpp"

namespace pantin::lua {

struct Dual {
  static constexpr int most = 12;  ///< four places

  double value = 0.0;
  int count = 0;                  ///< of derivatives; those beyond are 0
  std::array<double, most> rate;  ///< (count)

  Dual() = default;
  Dual(double v) : value(v) {}
  Dual(const Dual& other) { *this = other; }
  Dual& operator=(const Dual& other) {
    value = other.value;
    count = other.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i++) rate[i] = other.rate[i];
    return *this;
  }
  ~Dual() = default;
  /// The variable `which` of `of`.
  static Dual variable(double value, int which, int of);
  double slope(int i) const { return i < count ? rate[static_cast<std::size_t>(i)] : 0.0; }
};

/// Arithmetic of a law that is called: see algebra.cpp for what an algebra has.
struct DualAlgebra {
  using Number = Dual;
  static constexpr Tag number_tag = Tag::dual, vec_tag = Tag::dual_vec;

  explicit DualAlgebra(lua_State* state) : running(state) {}

  std::optional<Dual> read(lua_State* state, int index) const;
  std::optional<std::array<Dual, 3>> read_vec(lua_State* state, int index) const;
  void push(lua_State* state, const Dual& x) const;
  void push_vec(lua_State* state, const std::array<Dual, 3>& v) const;

  Dual constant(double x) const { return x; }
  Dual add(const Dual& a, const Dual& b) const;
  Dual subtract(const Dual& a, const Dual& b) const;
  Dual multiply(const Dual& a, const Dual& b) const;
  Dual divide(const Dual& a, const Dual& b) const;
  Dual modulo(const Dual& a, const Dual& b) const;
  Dual power(const Dual& a, const Dual& b) const;
  Dual apply(Function f, const Dual& a) const;
  Dual arc_tangent(const Dual& y, const Dual& x) const;
  Dual minimum(const Dual& a, const Dual& b) const { return b.value < a.value ? b : a; }
  Dual maximum(const Dual& a, const Dual& b) const { return b.value > a.value ? b : a; }
  Dual choose_below_zero(const Dual& a, const Dual& yes, const Dual& no) const { return a.value < 0 ? yes : no; }
  bool less(const Dual& a, const Dual& b) const { return a.value < b.value; }
  bool less_or_equal(const Dual& a, const Dual& b) const { return a.value <= b.value; }
  bool equal(const Dual& a, const Dual& b) const { return a.value == b.value; }
  /// Without derivative: a whole number as Lua has it.
  void push_floor(lua_State* state, const Dual& a) const;
  /// A mistake, but for print: what is worked out of a text would add to the energy and not to the force.
  std::string text(const Dual& a) const;
  /// What is not known of a number that carries derivatives is asked of its value.
  double plain(const Dual& a, const char*) const { return a.value; }

  lua_State* running;
};

}  // namespace pantin::lua
