#include "lua/test/expect.hpp"

#include <cmath>

#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

const char expectation_key = 0;

/// The value that is looked at, from the expectation at argument 1, takes its place; `most` arguments come after it.
void take_expected(lua_State* state, const char* call, int most) {
  check_count(state, most, call, 2);
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_rawgeti(state, 1, 1);
  lua_replace(state, 1);
}

std::string shown(lua_State* state, int index) {
  const bool quoted = lua_type(state, index) == LUA_TSTRING;
  const std::string s = lua_type(state, index) == LUA_TNUMBER && !lua_isinteger(state, index)
                            ? to_text(lua_tonumber(state, index))
                            : std::string(push_text(state, index));
  return quoted ? text("\"", s, "\"") : s;
}

double number(lua_State* state, int index) {
  require(lua_type(state, index) == LUA_TNUMBER, index == 1 ? "expected" : "the test gives", " a number, got ",
          kind_of_value(state, index));
  return lua_tonumber(state, index);
}

int near(lua_State* state) {
  take_expected(state, "near", 2);
  const double tolerance = check_number(state, 3, "near", "argument 2, the tolerance,", "");
  const auto a = to_vec(state, 1), b = to_vec(state, 2);
  const double off = a && b ? norm(*a - *b) : std::fabs(number(state, 1) - number(state, 2));
  require(off <= tolerance, "expected ", shown(state, 2), " within ", tolerance, ", got ", shown(state, 1),
          ", which is ", off, " off");
  return 0;
}

int below(lua_State* state) {
  take_expected(state, "below", 1);
  require(number(state, 1) < number(state, 2), "expected a number below ", shown(state, 2), ", got ", shown(state, 1));
  return 0;
}

int above(lua_State* state) {
  take_expected(state, "above", 1);
  require(number(state, 1) > number(state, 2), "expected a number above ", shown(state, 2), ", got ", shown(state, 1));
  return 0;
}

int equal(lua_State* state) {
  take_expected(state, "equal", 1);
  require(lua_compare(state, 1, 2, LUA_OPEQ) != 0, "expected ", shown(state, 2), ", got ", shown(state, 1));
  return 0;
}

int is_true(lua_State* state) {
  take_expected(state, "is_true", 0);
  require(lua_isboolean(state, 1) && lua_toboolean(state, 1), "expected true, got ", shown(state, 1));
  return 0;
}

int fails(lua_State* state) {
  take_expected(state, "fails", 1);
  const std::string wanted = check_text(state, 2, "fails", "argument 1");
  require(lua_isfunction(state, 1), "fails: expect must be given a function, got ", kind_of_value(state, 1));
  lua_pushvalue(state, 1);
  require(lua_pcall(state, 0, 0, 0) != LUA_OK, "expected an error with \"", wanted, "\", but there was none");
  const std::string message(push_text(state, -1));
  require(message.find(wanted) != std::string::npos, "expected an error with \"", wanted, "\", got \"", message, "\"");
  return 0;
}

int expect(lua_State* state) {
  check_count(state, 1, "expect");
  lua_settop(state, 1);
  lua_createtable(state, 1, 0);
  lua_pushvalue(state, 1);
  lua_rawseti(state, -2, 1);
  lua_rawgetp(state, LUA_REGISTRYINDEX, &expectation_key);
  lua_setmetatable(state, -2);
  return 1;
}

/// An expectation that is no function of ours would check nothing.
int unknown(lua_State* state) {
  throw Error(text("expect: unknown expectation '", push_text(state, 2),
                   "'. Known are near, below, above, equal, is_true, fails"));
}

}  // namespace

void open_expect(lua_State* state) {
  const luaL_Reg methods[] = {{"near", guard<near>},   {"below", guard<below>},     {"above", guard<above>},
                              {"equal", guard<equal>}, {"is_true", guard<is_true>}, {"fails", guard<fails>},
                              {nullptr, nullptr}};
  luaL_newlib(state, methods);
  lua_newtable(state);
  lua_pushcfunction(state, guard<unknown>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  lua_newtable(state);
  lua_insert(state, -2);
  lua_setfield(state, -2, "__index");
  lua_rawsetp(state, LUA_REGISTRYINDEX, &expectation_key);
  lua_register(state, "expect", guard<expect>);
}

}  // namespace pantin::lua
