#pragma once
// A number of which only the way it is made is known: what a law works with while it is traced.
#include <array>
#include <lua.hpp>
#include <optional>
#include <string>

#include "laws/expression.hpp"
#include "lua/value/values.hpp"

namespace pantin::lua {

class Trace;

/// Arithmetic of a law that is traced: see algebra.cpp for what an algebra has.
struct SymbolAlgebra {
  using Number = Expr;
  static constexpr Tag number_tag = Tag::symbol, vec_tag = Tag::symbol_vec;

  /// Throws where no law is being traced.
  explicit SymbolAlgebra(lua_State* state);

  std::optional<Expr> read(lua_State* state, int index) const;
  std::optional<std::array<Expr, 3>> read_vec(lua_State* state, int index) const;
  /// A constant is pushed as a plain number.
  void push(lua_State* state, Expr e) const;
  void push_vec(lua_State* state, const std::array<Expr, 3>& v) const;

  Expr constant(double x) const { return graph.constant(x); }
  Expr add(Expr a, Expr b) const { return graph.add(a, b); }
  Expr subtract(Expr a, Expr b) const { return graph.subtract(a, b); }
  Expr multiply(Expr a, Expr b) const { return graph.multiply(a, b); }
  Expr divide(Expr a, Expr b) const { return graph.divide(a, b); }
  Expr modulo(Expr a, Expr b) const { return graph.modulo(a, b); }
  Expr power(Expr a, Expr b) const { return graph.raise(a, b); }
  Expr apply(Function f, Expr a) const { return graph.apply(f, a); }
  Expr arc_tangent(Expr y, Expr x) const { return graph.apply(Function::atan2, y, x); }
  Expr minimum(Expr a, Expr b) const { return graph.apply(Function::minimum, a, b); }
  Expr maximum(Expr a, Expr b) const { return graph.apply(Function::maximum, a, b); }
  Expr choose_below_zero(Expr a, Expr yes, Expr no) const {
    return graph.select(graph.apply(Function::less, a, graph.constant(0.0)), yes, no);
  }
  /// Takes one side of a branch; the trace goes back for the other.
  bool less(Expr a, Expr b) const;
  bool less_or_equal(Expr a, Expr b) const;
  /// Refused, unless the law allows what is then always false.
  bool equal(Expr a, Expr b) const;
  void push_floor(lua_State* to, Expr a) const { push(to, graph.apply(Function::floor, a)); }
  [[noreturn]] std::string text(Expr a) const;
  [[noreturn]] double plain(Expr a, const char* what) const;

  lua_State* state;
  Trace& trace;
  Expressions& graph;
};

}  // namespace pantin::lua
