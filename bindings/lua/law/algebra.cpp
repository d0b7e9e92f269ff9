#include "lua/law/algebra.hpp"

#include <string>
#include <string_view>

#include "base/check.hpp"
#include "lua/law/dual.hpp"
#include "lua/law/symbol.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

template <class A>
using Vec = std::array<typename A::Number, 3>;

const char number_keys[2] = {}, vec_keys[2] = {};

bool is_vec(lua_State* state, int index) {
  const auto tag = tag_of(state, index);
  return tag == Tag::vec || tag == Tag::symbol_vec || tag == Tag::dual_vec;
}

template <class A>
typename A::Number operand(const A& algebra, lua_State* state, int index) {
  const auto x = algebra.read(state, index);
  require(x.has_value(), "arithmetic needs numbers, got ", kind_of_value(state, index),
          lua_isnil(state, index) ? " (a name that nothing was given to?)" : "");
  return *x;
}

template <class A>
Vec<A> vec_operand(const A& algebra, lua_State* state, int index, const char* operation) {
  const auto v = algebra.read_vec(state, index);
  require(v.has_value(), "vec ", operation, " needs two vecs, got ", kind_of_value(state, index));
  return *v;
}

/// Does it where both operands are numbers, as they mostly are.
template <class A, class Operation>
bool push_of_numbers(const A& algebra, lua_State* state, Operation operation) {
  const auto a = algebra.read(state, 1);
  if (!a) return false;
  const auto b = algebra.read(state, 2);
  if (!b) return false;
  algebra.push(state, (algebra.*operation)(*a, *b));
  return true;
}

template <class A>
int add(lua_State* state) {
  const A algebra(state);
  if (push_of_numbers(algebra, state, &A::add)) return 1;
  if (is_vec(state, 1) || is_vec(state, 2)) {
    const auto a = vec_operand(algebra, state, 1, "+"), b = vec_operand(algebra, state, 2, "+");
    algebra.push_vec(state, {algebra.add(a[0], b[0]), algebra.add(a[1], b[1]), algebra.add(a[2], b[2])});
  } else {
    algebra.push(state, algebra.add(operand(algebra, state, 1), operand(algebra, state, 2)));
  }
  return 1;
}

template <class A>
int subtract(lua_State* state) {
  const A algebra(state);
  if (push_of_numbers(algebra, state, &A::subtract)) return 1;
  if (is_vec(state, 1) || is_vec(state, 2)) {
    const auto a = vec_operand(algebra, state, 1, "-"), b = vec_operand(algebra, state, 2, "-");
    algebra.push_vec(state, {algebra.subtract(a[0], b[0]), algebra.subtract(a[1], b[1]), algebra.subtract(a[2], b[2])});
  } else {
    algebra.push(state, algebra.subtract(operand(algebra, state, 1), operand(algebra, state, 2)));
  }
  return 1;
}

template <class A>
void push_scaled(const A& algebra, lua_State* state, const Vec<A>& v, const typename A::Number& x) {
  algebra.push_vec(state, {algebra.multiply(v[0], x), algebra.multiply(v[1], x), algebra.multiply(v[2], x)});
}

template <class A>
int multiply(lua_State* state) {
  const A algebra(state);
  if (push_of_numbers(algebra, state, &A::multiply)) return 1;
  const bool first = is_vec(state, 1), second = is_vec(state, 2);
  require(!(first && second), "vec * vec could mean two things: write a:dot(b) or a:cross(b)");
  if (!first && !second) {
    algebra.push(state, algebra.multiply(operand(algebra, state, 1), operand(algebra, state, 2)));
    return 1;
  }
  const auto x = algebra.read(state, first ? 2 : 1);
  require(x.has_value(), "vec * needs a number, got ", kind_of_value(state, first ? 2 : 1));
  push_scaled(algebra, state, *algebra.read_vec(state, first ? 1 : 2), *x);
  return 1;
}

template <class A>
int divide(lua_State* state) {
  const A algebra(state);
  if (push_of_numbers(algebra, state, &A::divide)) return 1;
  if (!is_vec(state, 1) && !is_vec(state, 2)) {
    algebra.push(state, algebra.divide(operand(algebra, state, 1), operand(algebra, state, 2)));
    return 1;
  }
  const auto v = algebra.read_vec(state, 1);
  const auto x = algebra.read(state, 2);
  require(v && x, "vec / needs a vec and a number, got ", kind_of_value(state, 1), " / ", kind_of_value(state, 2));
  algebra.push_vec(state, {algebra.divide((*v)[0], *x), algebra.divide((*v)[1], *x), algebra.divide((*v)[2], *x)});
  return 1;
}

template <class A>
int negate(lua_State* state) {
  const A algebra(state);
  const auto minus = algebra.constant(-1.0);
  if (const auto v = algebra.read_vec(state, 1))
    push_scaled(algebra, state, *v, minus);
  else
    algebra.push(state, algebra.multiply(operand(algebra, state, 1), minus));
  return 1;
}

template <class A>
int modulo(lua_State* state) {
  const A algebra(state);
  algebra.push(state, algebra.modulo(operand(algebra, state, 1), operand(algebra, state, 2)));
  return 1;
}

template <class A>
int floor_divide(lua_State* state) {
  const A algebra(state);
  const auto quotient = algebra.divide(operand(algebra, state, 1), operand(algebra, state, 2));
  algebra.push(state, algebra.apply(Function::floor, quotient));
  return 1;
}

template <class A>
int power(lua_State* state) {
  const A algebra(state);
  algebra.push(state, algebra.power(operand(algebra, state, 1), operand(algebra, state, 2)));
  return 1;
}

template <class A>
typename A::Number compared(const A& algebra, lua_State* state, int index) {
  const auto x = algebra.read(state, index);
  require(x.has_value(), "a number cannot be compared with ", kind_of_value(state, index));
  return *x;
}

template <class A>
int less(lua_State* state) {
  const A algebra(state);
  lua_pushboolean(state, algebra.less(compared(algebra, state, 1), compared(algebra, state, 2)));
  return 1;
}

template <class A>
int less_or_equal(lua_State* state) {
  const A algebra(state);
  lua_pushboolean(state, algebra.less_or_equal(compared(algebra, state, 1), compared(algebra, state, 2)));
  return 1;
}

template <class A>
int equal(lua_State* state) {
  const A algebra(state);
  bool same = true;
  if (is_vec(state, 1) && is_vec(state, 2)) {
    const auto a = *algebra.read_vec(state, 1), b = *algebra.read_vec(state, 2);
    for (std::size_t i = 0; i < 3; i++) same = algebra.equal(a[i], b[i]) && same;
  } else {
    const auto a = algebra.read(state, 1), b = algebra.read(state, 2);
    same = a && b && algebra.equal(*a, *b);
  }
  lua_pushboolean(state, same);
  return 1;
}

template <class A>
int to_string(lua_State* state) {
  const A algebra(state);
  std::string s;
  if (const auto v = algebra.read_vec(state, 1))
    s = text("vec(", algebra.text((*v)[0]), ", ", algebra.text((*v)[1]), ", ", algebra.text((*v)[2]), ")");
  else
    s = algebra.text(*algebra.read(state, 1));
  lua_pushlstring(state, s.data(), s.size());
  return 1;
}

template <class A>
int concatenate(lua_State* state) {
  lua_settop(state, 2);
  push_text(state, 1);
  push_text(state, 2);
  lua_concat(state, 2);
  return 1;
}

int refuse_index(lua_State* state) {
  throw Error(text("a number has no fields; '", push_text(state, 2), "' was asked of one"));
}

int refuse_change(lua_State*) { throw Error("a number or vec of a law cannot be changed; make a new one"); }
int refuse_call(lua_State*) { throw Error("a number cannot be called"); }
int refuse_length(lua_State*) { throw Error("a number has no length #"); }
int refuse_bits(lua_State*) { throw Error("operations on bits need whole numbers; the law's numbers are not"); }

template <class A>
typename A::Number product(const A& algebra, const Vec<A>& a, const Vec<A>& b) {
  return algebra.add(algebra.add(algebra.multiply(a[0], b[0]), algebra.multiply(a[1], b[1])),
                     algebra.multiply(a[2], b[2]));
}

template <class A>
int dot(lua_State* state) {
  check_count(state, 1, "vec:dot", 2);
  const A algebra(state);
  const auto a = vec_operand(algebra, state, 1, ":dot"), b = vec_operand(algebra, state, 2, ":dot");
  algebra.push(state, product(algebra, a, b));
  return 1;
}

template <class A>
int cross(lua_State* state) {
  check_count(state, 1, "vec:cross", 2);
  const A algebra(state);
  const auto a = vec_operand(algebra, state, 1, ":cross"), b = vec_operand(algebra, state, 2, ":cross");
  const auto part = [&](std::size_t i, std::size_t j) {
    return algebra.subtract(algebra.multiply(a[i], b[j]), algebra.multiply(a[j], b[i]));
  };
  algebra.push_vec(state, {part(1, 2), part(2, 0), part(0, 1)});
  return 1;
}

template <class A>
typename A::Number length_of(const A& algebra, const Vec<A>& v) {
  return algebra.power(product(algebra, v, v), algebra.constant(0.5));
}

template <class A>
int length(lua_State* state) {
  check_count(state, 0, "vec:length", 2);
  const A algebra(state);
  algebra.push(state, length_of(algebra, vec_operand(algebra, state, 1, ":length")));
  return 1;
}

template <class A>
int normalized(lua_State* state) {
  check_count(state, 0, "vec:normalized", 2);
  const A algebra(state);
  const auto v = vec_operand(algebra, state, 1, ":normalized");
  push_scaled(algebra, state, v, algebra.divide(algebra.constant(1.0), length_of(algebra, v)));
  return 1;
}

/// Upvalue: the methods.
template <class A>
int vec_index(lua_State* state) {
  const A algebra(state);
  const auto v = algebra.read_vec(state, 1);
  std::string_view key;
  if (lua_type(state, 2) == LUA_TSTRING) key = lua_tostring(state, 2);
  if (key.size() == 1 && key[0] >= 'x' && key[0] <= 'z') {
    algebra.push(state, (*v)[static_cast<std::size_t>(key[0] - 'x')]);
    return 1;
  }
  return push_vec_method(state);
}

template <class A>
int make(lua_State* state) {
  const A algebra(state);
  Vec<A> v;
  for (int i = 0; i < 3; i++) {
    const auto x = algebra.read(state, i + 1);
    require(x.has_value(), "vec: ", "xyz"[i], " must be a number, got ", kind_of_value(state, i + 1));
    v[static_cast<std::size_t>(i)] = *x;
  }
  require(lua_gettop(state) == 3, "vec: takes three numbers, got ", lua_gettop(state), " values");
  algebra.push_vec(state, v);
  return 1;
}

template <class A>
void push_number_metatable(lua_State* state) {
  lua_newtable(state);
  const luaL_Reg operators[] = {{"__add", guard<add<A>>},
                                {"__sub", guard<subtract<A>>},
                                {"__mul", guard<multiply<A>>},
                                {"__div", guard<divide<A>>},
                                {"__mod", guard<modulo<A>>},
                                {"__idiv", guard<floor_divide<A>>},
                                {"__pow", guard<power<A>>},
                                {"__unm", guard<negate<A>>},
                                {"__lt", guard<less<A>>},
                                {"__le", guard<less_or_equal<A>>},
                                {"__eq", guard<equal<A>>},
                                {"__tostring", guard<to_string<A>>},
                                {"__concat", guard<concatenate<A>>},
                                {"__index", guard<refuse_index>},
                                {"__newindex", guard<refuse_change>},
                                {"__call", guard<refuse_call>},
                                {"__len", guard<refuse_length>},
                                {"__band", guard<refuse_bits>},
                                {"__bor", guard<refuse_bits>},
                                {"__bxor", guard<refuse_bits>},
                                {"__bnot", guard<refuse_bits>},
                                {"__shl", guard<refuse_bits>},
                                {"__shr", guard<refuse_bits>},
                                {nullptr, nullptr}};
  luaL_setfuncs(state, operators, 0);
}

template <class A>
void push_vec_metatable(lua_State* state) {
  lua_newtable(state);
  const luaL_Reg operators[] = {{"__add", guard<add<A>>},
                                {"__sub", guard<subtract<A>>},
                                {"__mul", guard<multiply<A>>},
                                {"__div", guard<divide<A>>},
                                {"__unm", guard<negate<A>>},
                                {"__eq", guard<equal<A>>},
                                {"__tostring", guard<to_string<A>>},
                                {"__newindex", guard<refuse_change>},
                                {nullptr, nullptr}};
  luaL_setfuncs(state, operators, 0);
  lua_newtable(state);
  const luaL_Reg methods[] = {{"dot", guard<dot<A>>},
                              {"cross", guard<cross<A>>},
                              {"length", guard<length<A>>},
                              {"normalized", guard<normalized<A>>},
                              {nullptr, nullptr}};
  luaL_setfuncs(state, methods, 0);
  lua_pushcclosure(state, guard<vec_index<A>>, 1);
  lua_setfield(state, -2, "__index");
}

void push_metatable(lua_State* state, Tag tag) {
  const bool symbol = tag == Tag::symbol || tag == Tag::symbol_vec, number = tag == Tag::symbol || tag == Tag::dual;
  const void* key = number ? &number_keys[symbol] : &vec_keys[symbol];
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, key) != LUA_TNIL) return;
  lua_pop(state, 1);
  switch (tag) {
    case Tag::symbol: push_number_metatable<SymbolAlgebra>(state); break;
    case Tag::symbol_vec: push_vec_metatable<SymbolAlgebra>(state); break;
    case Tag::dual: push_number_metatable<DualAlgebra>(state); break;
    default: push_vec_metatable<DualAlgebra>(state);
  }
  for (const char* field : {"__name", "__metatable"}) {
    lua_pushstring(state, !number ? "vec" : symbol ? "number that differs from pair to pair" : number_with_derivative);
    lua_setfield(state, -2, field);
  }
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, key);
}

template <class A>
int operate(lua_State* state, VecOperation operation) {
  switch (operation) {
    case VecOperation::add: return add<A>(state);
    case VecOperation::subtract: return subtract<A>(state);
    case VecOperation::multiply: return multiply<A>(state);
    case VecOperation::divide: return divide<A>(state);
    case VecOperation::dot: return dot<A>(state);
    case VecOperation::cross: return cross<A>(state);
    case VecOperation::make: break;
  }
  return make<A>(state);
}

}  // namespace

void set_algebra_metatable(lua_State* state, Tag tag) {
  if (lua_gettop(state) > 1 && tag_of(state, 1) == tag)  // mostly an operand, whose is at hand
    lua_getmetatable(state, 1);
  else
    push_metatable(state, tag);
  lua_setmetatable(state, -2);
}

bool has_law_value(lua_State* state, int count) {
  for (int i = 1; i <= count; i++) {
    const auto tag = tag_of(state, i);
    if (tag && *tag >= Tag::symbol && *tag <= Tag::dual_vec) return true;
  }
  return false;
}

bool is_traced(lua_State* state, int count) {
  for (int i = 1; i <= count; i++) {
    const auto tag = tag_of(state, i);
    if (tag == Tag::symbol || tag == Tag::symbol_vec) return true;
  }
  return false;
}

int law_vec(lua_State* state, VecOperation operation) {
  return is_traced(state, lua_gettop(state)) ? operate<SymbolAlgebra>(state, operation)
                                             : operate<DualAlgebra>(state, operation);
}

}  // namespace pantin::lua
