// Expressions as texts that LAMMPS and Lepton read. Lua reads them here, with what these have defined as they define it.
#include "player/lammps/formula.hpp"

#include <catch2/catch.hpp>
#include <lua.hpp>
#include <memory>

#include "base/check.hpp"
#include "laws/expression.hpp"

using namespace pantin;
using player::FormulaFor;

namespace {

const char* const readers = R"(
for _, name in ipairs { "sqrt", "exp", "sin", "cos", "tan", "asin", "acos", "atan", "abs", "floor", "min", "max", "log" } do
  _G[name] = math[name]
end
ln, atan2, sinh = math.log, math.atan, function() error("neither has it") end
function step(x) return x < 0 and 0 or 1 end
function select(x, y, z) return x ~= 0 and y or z end
local function value(x) return x == true and 1 or x == false and 0 or x end
debug.setmetatable(true, { __mul = function(a, b) return value(a) * value(b) end, __add = function(a, b) return value(a) + value(b) end,
  __sub = function(a, b) return value(a) - value(b) end })
function read(text, a, b, at)
  r, x, y = at, a, b
  return value(assert(load("return " .. text, text))())
end
)";

/// What a reader makes of a text.
double read(const std::string& text, double x, double y, double r) {
  const std::unique_ptr<lua_State, decltype(&lua_close)> state(luaL_newstate(), lua_close);
  luaL_openlibs(state.get());
  REQUIRE(luaL_dostring(state.get(), readers) == LUA_OK);
  lua_getglobal(state.get(), "read");
  lua_pushstring(state.get(), text.c_str());
  for (const double value : {x, y, r}) lua_pushnumber(state.get(), value);
  INFO(text);
  const int failed = lua_pcall(state.get(), 4, 1, 0);
  if (failed != LUA_OK) FAIL(lua_tostring(state.get(), -1));
  return lua_tonumber(state.get(), -1);
}

std::string name_of(const Input& input) { return input.component == 0 ? "x" : "y"; }

}  // namespace

TEST_CASE("formula: each function means the same to its reader") {
  Expressions g;
  const Input of_x{Role::position, 0, 0, {}}, of_y{Role::position, 0, 1, {}};
  const Expr x = g.input(of_x), y = g.input(of_y), two = g.constant(2.0);
  std::vector<Expr> list = {g.sum(-1.5, {{x, -0.25}, {y, 3.0}}), g.multiply(g.power(x, -2.0), g.square_root(y)),
                            g.apply(Function::power, x, y), g.divide(g.constant(1.0), g.add(x, y))};
  for (Function f :
       {Function::exp, Function::log, Function::sin, Function::cos, Function::tan, Function::asin, Function::acos,
        Function::atan, Function::sinh, Function::cosh, Function::tanh, Function::abs, Function::floor})
    list.push_back(g.apply(f, g.scale(x, 0.5)));
  for (Function f : {Function::atan2, Function::minimum, Function::maximum, Function::less, Function::less_or_equal}) {
    list.push_back(g.apply(f, x, y));
    list.push_back(g.apply(f, y, x));
    list.push_back(g.apply(f, x, two));
  }
  for (Function f : {Function::less, Function::less_or_equal}) {
    list.push_back(g.select(g.apply(f, x, y), g.multiply(x, y), g.add(x, y)));
    list.push_back(g.select(g.apply(f, y, x), g.multiply(x, y), g.add(x, y)));
  }
  for (const auto& [a, b] : {std::pair(0.7, 1.9), std::pair(1.3, 0.2), std::pair(2.0, 2.0)})
    for (Expr e : list)
      for (FormulaFor reader : {FormulaFor::variable, FormulaFor::lepton}) {
        const std::string text = formula(g, e, reader, name_of);
        INFO(text << " at " << a << ", " << b);
        std::vector<double> values;
        for (const Input& input : g.inputs()) values.push_back(input.component == 0 ? a : b);
        CHECK(read(text, a, b, 0.0) == Approx(g.evaluate(e, values)).epsilon(1e-14).margin(1e-300));
      }
}

TEST_CASE("formula: the distance of a pair is r, in whole powers where it can be") {
  Expressions g;
  const Expr q = g.input({Role::distance2, 0, 0, {}});
  CHECK(formula(g, g.power(q, -3.0), FormulaFor::lepton, name_of) == "((r^(-6)))");
  CHECK(formula(g, g.square_root(q), FormulaFor::lepton, name_of) == "(r)");
  CHECK(formula(g, q, FormulaFor::lepton, name_of) == "(r^2)");
}

TEST_CASE("formula: a table of points is none") {
  Expressions g;
  const std::vector<double> x = {0.0, 1.0, 2.0}, y = {0.0, 1.0, 0.0};
  const Expr e = g.spline(std::make_shared<Spline>(x, y), g.input({Role::position, 0, 0, {}}));
  CHECK_THROWS_WITH(formula(g, e, FormulaFor::variable, name_of), "it is made of a table of points");
}
