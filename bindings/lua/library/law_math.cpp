// The functions of `math`, and `type`, for numbers of laws: each takes the place of the plain one, and hands on to it.
#include "lua/law/algebra.hpp"
#include "lua/law/dual.hpp"
#include "lua/law/symbol.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

template <class A>
typename A::Number argument(const A& algebra, lua_State* state, int index, const char* what) {
  const auto x = algebra.read(state, index);
  require(x.has_value(), what, ": argument ", index, " must be a number, got ", kind_of_value(state, index));
  return *x;
}

template <Function f>
struct Apply {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    algebra.push(state, algebra.apply(f, argument(algebra, state, 1, "math")));
    return 1;
  }
};

struct SquareRoot {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    algebra.push(state, algebra.power(argument(algebra, state, 1, "math.sqrt"), algebra.constant(0.5)));
    return 1;
  }
};

struct Logarithm {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    auto value = algebra.apply(Function::log, argument(algebra, state, 1, "math.log"));
    if (!lua_isnoneornil(state, 2))
      value = algebra.divide(value, algebra.apply(Function::log, argument(algebra, state, 2, "math.log")));
    algebra.push(state, value);
    return 1;
  }
};

struct ArcTangent {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    const auto y = argument(algebra, state, 1, "math.atan");
    algebra.push(state, lua_isnoneornil(state, 2) ? algebra.apply(Function::atan, y)
                                                  : algebra.arc_tangent(y, argument(algebra, state, 2, "math.atan")));
    return 1;
  }
};

struct Floor {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    algebra.push_floor(state, argument(algebra, state, 1, "math.floor"));
    return 1;
  }
};

struct Ceiling {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    algebra.push_floor(state, algebra.multiply(argument(algebra, state, 1, "math.ceil"), algebra.constant(-1.0)));
    lua_arith(state, LUA_OPUNM);
    return 1;
  }
};

template <bool least>
struct Extreme {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    const char* const what = least ? "math.min" : "math.max";
    auto value = argument(algebra, state, 1, what);
    for (int i = 2; i <= lua_gettop(state); i++) {
      const auto other = argument(algebra, state, i, what);
      value = least ? algebra.minimum(value, other) : algebra.maximum(value, other);
    }
    algebra.push(state, value);
    return 1;
  }
};

/// Towards 0.
template <class A>
typename A::Number whole(const A& algebra, const typename A::Number& x) {
  const auto minus = algebra.constant(-1.0);
  const auto above = algebra.multiply(algebra.apply(Function::floor, algebra.multiply(x, minus)), minus);
  return algebra.choose_below_zero(x, above, algebra.apply(Function::floor, x));
}

struct Remainder {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    const auto a = argument(algebra, state, 1, "math.fmod"), b = argument(algebra, state, 2, "math.fmod");
    algebra.push(state, algebra.subtract(a, algebra.multiply(whole(algebra, algebra.divide(a, b)), b)));
    return 1;
  }
};

struct Parts {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    const auto x = argument(algebra, state, 1, "math.modf"), i = whole(algebra, x);
    algebra.push(state, i);
    algebra.push(state, algebra.subtract(x, i));
    return 2;
  }
};

/// Functions that have no meaning for symbols; numbers with derivatives go in without them.
struct Plain {
  template <class A>
  static int run(const A& algebra, lua_State* state) {
    for (int i = 1; i <= lua_gettop(state); i++) {
      const auto x = algebra.read(state, i);
      if (!x) continue;
      lua_pushnumber(state, algebra.plain(*x, "the kind or the digits"));
      lua_replace(state, i);
    }
    return lua_tocfunction(state, lua_upvalueindex(1))(state);
  }
};

/// Upvalue: the plain function.
template <class Operation>
int either(lua_State* state) {
  const int count = lua_gettop(state);
  if (!has_law_value(state, count)) return lua_tocfunction(state, lua_upvalueindex(1))(state);
  return is_traced(state, count) ? Operation::run(SymbolAlgebra(state), state)
                                 : Operation::run(DualAlgebra(state), state);
}

int type_of_value(lua_State* state) {
  const auto tag = tag_of(state, 1);
  if (tag == Tag::symbol || tag == Tag::dual) {
    lua_pushliteral(state, "number");
    return 1;
  }
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

void replace_function(lua_State* state, const char* name, lua_CFunction function) {
  lua_getfield(state, -1, name);
  lua_pushcclosure(state, function, 1);
  lua_setfield(state, -2, name);
}

}  // namespace

void open_law_math(lua_State* state) {
  const luaL_Reg functions[] = {{"sqrt", guard<either<SquareRoot>>},
                                {"exp", guard<either<Apply<Function::exp>>>},
                                {"log", guard<either<Logarithm>>},
                                {"sin", guard<either<Apply<Function::sin>>>},
                                {"cos", guard<either<Apply<Function::cos>>>},
                                {"tan", guard<either<Apply<Function::tan>>>},
                                {"asin", guard<either<Apply<Function::asin>>>},
                                {"acos", guard<either<Apply<Function::acos>>>},
                                {"atan", guard<either<ArcTangent>>},
                                {"sinh", guard<either<Apply<Function::sinh>>>},
                                {"cosh", guard<either<Apply<Function::cosh>>>},
                                {"tanh", guard<either<Apply<Function::tanh>>>},
                                {"abs", guard<either<Apply<Function::abs>>>},
                                {"floor", guard<either<Floor>>},
                                {"ceil", guard<either<Ceiling>>},
                                {"min", guard<either<Extreme<true>>>},
                                {"max", guard<either<Extreme<false>>>},
                                {"fmod", guard<either<Remainder>>},
                                {"modf", guard<either<Parts>>},
                                {"tointeger", guard<either<Plain>>},
                                {"type", guard<either<Plain>>},
                                {"ult", guard<either<Plain>>}};
  lua_getglobal(state, "math");
  for (const luaL_Reg& f : functions) replace_function(state, f.name, f.func);
  lua_pop(state, 1);
  lua_pushglobaltable(state);
  replace_function(state, "type", guard<type_of_value>);
  lua_pop(state, 1);
}

}  // namespace pantin::lua
