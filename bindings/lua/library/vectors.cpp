// vec and quat as scripts have them: how they are made, their operators and their methods. Where an operand is of a law,
// the law's algebra does it.
#include <string_view>

#include "base/functions.hpp"
#include "lua/law/algebra.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

std::string number_text(double value) { return to_text(value == 0.0 ? 0.0 : value); }

/// An operand, or an error that says what the operation needs.
Vec3 operand(lua_State* state, int index, const char* operation) {
  const auto v = to_vec(state, index);
  require(v.has_value(), "vec ", operation, " needs two vecs, got ", kind_of_value(state, index));
  return *v;
}

int make_vec(lua_State* state) {
  if (has_law_value(state, 3)) return law_vec(state, VecOperation::make);
  double v[3];
  for (int i = 0; i < 3; i++) {
    if (lua_type(state, i + 1) != LUA_TNUMBER)
      throw Error(text("vec: ", "xyz"[i], " must be a number, got ", kind_of_value(state, i + 1)));
    v[i] = lua_tonumber(state, i + 1);
  }
  require(lua_gettop(state) == 3, "vec: takes three numbers, got ", lua_gettop(state), " values");
  push(state, vec(v[0], v[1], v[2]));
  return 1;
}

int vec_add(lua_State* state) {
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::add);
  return push(state, operand(state, 1, "+") + operand(state, 2, "+")), 1;
}
int vec_subtract(lua_State* state) {
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::subtract);
  return push(state, operand(state, 1, "-") - operand(state, 2, "-")), 1;
}
int vec_negate(lua_State* state) { return push(state, zero3() - operand(state, 1, "-")), 1; }

int vec_multiply(lua_State* state) {
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::multiply);
  const auto a = to_vec(state, 1), b = to_vec(state, 2);
  require(!(a && b), "vec * vec could mean two things: write a:dot(b) or a:cross(b)");
  const int other = a ? 2 : 1;
  require(lua_type(state, other) == LUA_TNUMBER, "vec * needs a number, got ", kind_of_value(state, other));
  push(state, (a ? *a : *b) * static_cast<double>(lua_tonumber(state, other)));
  return 1;
}

int vec_divide(lua_State* state) {
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::divide);
  const auto a = to_vec(state, 1);
  require(a && lua_type(state, 2) == LUA_TNUMBER, "vec / needs a vec and a number, got ", kind_of_value(state, 1),
          " / ", kind_of_value(state, 2));
  push(state, *a / static_cast<double>(lua_tonumber(state, 2)));
  return 1;
}

int vec_equal(lua_State* state) {
  const auto a = to_vec(state, 1), b = to_vec(state, 2);
  lua_pushboolean(state, a && b && same(*a, *b));
  return 1;
}

int vec_text(lua_State* state) {
  const Vec3 v = operand(state, 1, "tostring");
  const std::string s = text("vec(", number_text(v[0]), ", ", number_text(v[1]), ", ", number_text(v[2]), ")");
  lua_pushlstring(state, s.data(), s.size());
  return 1;
}

int vec_dot(lua_State* state) {
  check_count(state, 1, "vec:dot", 2);
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::dot);
  return lua_pushnumber(state, dot(operand(state, 1, ":dot"), operand(state, 2, ":dot"))), 1;
}
int vec_cross(lua_State* state) {
  check_count(state, 1, "vec:cross", 2);
  if (has_law_value(state, 2)) return law_vec(state, VecOperation::cross);
  return push(state, cross(operand(state, 1, ":cross"), operand(state, 2, ":cross"))), 1;
}
int vec_length(lua_State* state) {
  check_count(state, 0, "vec:length", 2);
  return lua_pushnumber(state, norm(operand(state, 1, ":length"))), 1;
}
int vec_normalized(lua_State* state) {
  check_count(state, 0, "vec:normalized", 2);
  const Vec3 v = operand(state, 1, ":normalized");
  require(norm(v) > 0.0, "vec(0, 0, 0) has no direction to be normalized to");
  push(state, v / norm(v));
  return 1;
}

int vec_index(lua_State* state) {
  const Vec3 v = operand(state, 1, "field");
  std::string_view key;
  if (lua_type(state, 2) == LUA_TSTRING) key = lua_tostring(state, 2);
  if (key.size() == 1 && key[0] >= 'x' && key[0] <= 'z') {
    lua_pushnumber(state, v[key[0] - 'x']);
    return 1;
  }
  return push_vec_method(state);
}

int vec_change(lua_State* state) {
  const std::string key(push_text(state, 2));
  throw Error(text("vec: ", key, " of a vec cannot be changed; instead of thing.position.", key,
                   " = … write thing.position = vec(x, y, z), or add: thing.position + vec(0, 1, 0)"));
}

int make_quat(lua_State* state) {
  check_count(state, 2, "quat");
  const auto axis = to_vec(state, 1);
  require(axis && finite(*axis) && norm(*axis) > 0.0,
          "quat: argument 1 must be an axis, a finite vec that is not 0, got ", kind_of_value(state, 1));
  const double half = check_number(state, 2, "quat", "argument 2, the angle,", "rad") / 2.0;
  const Vec3 u = *axis / norm(*axis) * functions::sin(half);
  push(state, Quat{functions::cos(half), u[0], u[1], u[2]});
  return 1;
}

Quat quat_operand(lua_State* state, int index) {
  const auto q = to_quat(state, index);
  require(q.has_value(), "quat: must be a quat, got ", kind_of_value(state, index));
  return *q;
}

int quat_multiply(lua_State* state) {
  require(!to_vec(state, 2), "quat * vec: write q:rotate(v)");
  push(state, quat_operand(state, 1) * quat_operand(state, 2));
  return 1;
}

int quat_equal(lua_State* state) {
  lua_pushboolean(state, same(quat_operand(state, 1), quat_operand(state, 2)));
  return 1;
}

int quat_text(lua_State* state) {
  const Quat q = quat_operand(state, 1);
  const std::string s = text("quat of w ", q.w, ", x ", q.x, ", y ", q.y, ", z ", q.z);
  lua_pushlstring(state, s.data(), s.size());
  return 1;
}

int quat_rotate(lua_State* state) {
  check_count(state, 1, "quat:rotate", 2);
  push(state, rotate(quat_operand(state, 1), check_vec(state, 2, "quat", "argument 1 of rotate", "")));
  return 1;
}

int quat_inverse(lua_State* state) {
  check_count(state, 0, "quat:inverse", 2);
  return push(state, conjugate(quat_operand(state, 1))), 1;
}

int quat_index(lua_State* state) {
  const Quat q = quat_operand(state, 1);
  std::string_view key;
  if (lua_type(state, 2) == LUA_TSTRING) key = lua_tostring(state, 2);
  const double parts[] = {q.w, q.x, q.y, q.z};
  if (key.size() == 1 && key[0] >= 'w' && key[0] <= 'z') {
    lua_pushnumber(state, parts[key[0] - 'w']);
    return 1;
  }
  lua_pushvalue(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  if (lua_isnil(state, -1))
    throw Error(
        text("quat: unknown field '", push_text(state, 2), "'; it has w, x, y, z and the methods rotate, inverse"));
  return 1;
}

int quat_change(lua_State*) { throw Error("quat: cannot be changed; make a new one with quat(axis, angle)"); }

void open_value(lua_State* state, const char* name, const void* key, const luaL_Reg* operators, const luaL_Reg* methods,
                lua_CFunction index) {
  lua_newtable(state);
  luaL_setfuncs(state, operators, 0);
  lua_pushstring(state, name);
  lua_setfield(state, -2, "__name");
  lua_pushstring(state, name);
  lua_setfield(state, -2, "__metatable");
  lua_newtable(state);
  luaL_setfuncs(state, methods, 0);
  lua_pushcclosure(state, index, 1);
  lua_setfield(state, -2, "__index");
  lua_rawsetp(state, LUA_REGISTRYINDEX, key);
}

}  // namespace

void open_vectors(lua_State* state) {
  const luaL_Reg vec_operators[] = {
      {"__add", guard<vec_add>},       {"__sub", guard<vec_subtract>},    {"__unm", guard<vec_negate>},
      {"__mul", guard<vec_multiply>},  {"__div", guard<vec_divide>},      {"__eq", guard<vec_equal>},
      {"__tostring", guard<vec_text>}, {"__newindex", guard<vec_change>}, {nullptr, nullptr}};
  const luaL_Reg vec_methods[] = {{"dot", guard<vec_dot>},
                                  {"cross", guard<vec_cross>},
                                  {"length", guard<vec_length>},
                                  {"normalized", guard<vec_normalized>},
                                  {nullptr, nullptr}};
  open_value(state, "vec", metatable_key(Tag::vec), vec_operators, vec_methods, guard<vec_index>);
  const luaL_Reg quat_operators[] = {{"__mul", guard<quat_multiply>},
                                     {"__eq", guard<quat_equal>},
                                     {"__tostring", guard<quat_text>},
                                     {"__newindex", guard<quat_change>},
                                     {nullptr, nullptr}};
  const luaL_Reg quat_methods[] = {
      {"rotate", guard<quat_rotate>}, {"inverse", guard<quat_inverse>}, {nullptr, nullptr}};
  open_value(state, "quat", metatable_key(Tag::quat), quat_operators, quat_methods, guard<quat_index>);
  lua_register(state, "vec", guard<make_vec>);
  lua_register(state, "quat", guard<make_quat>);
}

}  // namespace pantin::lua
