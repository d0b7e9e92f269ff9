// The part of Lua's math library that is made anew: the same bits in every run and on every processor.
#include <cmath>
#include <cstdint>

#include "base/functions.hpp"
#include "lua/law/law_run.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

template <double (*function)(double)>
int unary(lua_State* state) {
  lua_pushnumber(state, function(luaL_checknumber(state, 1)));
  return 1;
}

int arc_tangent(lua_State* state) {
  const double y = luaL_checknumber(state, 1);
  lua_pushnumber(state,
                 lua_isnoneornil(state, 2) ? functions::atan(y) : functions::atan2(y, luaL_checknumber(state, 2)));
  return 1;
}

int logarithm(lua_State* state) {
  const double x = luaL_checknumber(state, 1);
  if (lua_isnoneornil(state, 2)) {
    lua_pushnumber(state, functions::log(x));
    return 1;
  }
  const double base = luaL_checknumber(state, 2);
  if (base == 2.0)
    lua_pushnumber(state, functions::log2(x));
  else if (base == 10.0)
    lua_pushnumber(state, functions::log10(x));
  else
    lua_pushnumber(state, functions::log(x) / functions::log(base));
  return 1;
}

/// Uniform in 0 … last, by throwing away the bits that would make some numbers likelier.
std::uint64_t below(Random& random, std::uint64_t last) {
  if (last == ~std::uint64_t{0}) return random.bits();
  const std::uint64_t count = last + 1, uneven = (~std::uint64_t{0} % count + 1) % count;
  std::uint64_t bits = random.bits();
  while (bits < uneven) bits = random.bits();
  return bits % count;
}

int random_number(lua_State* state) {
  forbid_in_law(state, "math.random", "noise()");
  Random& random = *Runtime::of(state).random;
  const int count = lua_gettop(state);
  if (count == 0) {
    lua_pushnumber(state, random.uniform());
    return 1;
  }
  luaL_argcheck(state, count <= 2, 3, "at most two numbers are allowed");
  const lua_Integer low = count == 2 ? luaL_checkinteger(state, 1) : 1;
  const lua_Integer high = luaL_checkinteger(state, count);
  if (count == 1 && high == 0) {
    lua_pushinteger(state, static_cast<lua_Integer>(random.bits()));
    return 1;
  }
  luaL_argcheck(state, low <= high, count, "the interval is empty");
  const auto from = static_cast<std::uint64_t>(low);
  lua_pushinteger(state, static_cast<lua_Integer>(from + below(random, static_cast<std::uint64_t>(high) - from)));
  return 1;
}

int random_seed(lua_State*) { throw Error("math.randomseed is not for scenes; set scene.seed = n instead"); }

}  // namespace

void open_math(lua_State* state) {
  const luaL_Reg replaced[] = {{"sin", guard<unary<functions::sin>>},
                               {"cos", guard<unary<functions::cos>>},
                               {"tan", guard<unary<functions::tan>>},
                               {"asin", guard<unary<functions::asin>>},
                               {"acos", guard<unary<functions::acos>>},
                               {"atan", guard<arc_tangent>},
                               {"sinh", guard<unary<functions::sinh>>},
                               {"cosh", guard<unary<functions::cosh>>},
                               {"tanh", guard<unary<functions::tanh>>},
                               {"exp", guard<unary<functions::exp>>},
                               {"log", guard<logarithm>},
                               {"random", guard<random_number>},
                               {"randomseed", guard<random_seed>},
                               {nullptr, nullptr}};
  lua_getglobal(state, "math");
  luaL_setfuncs(state, replaced, 0);
  // Leftovers of Lua 5.3 that some builds of Lua have, with the C library's bits.
  for (const char* name : {"pow", "frexp", "ldexp", "log10"}) {
    lua_pushnil(state);
    lua_setfield(state, -2, name);
  }
  lua_pop(state, 1);
}

}  // namespace pantin::lua
