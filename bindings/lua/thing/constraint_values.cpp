#include "lua/thing/constraint_values.hpp"

#include <algorithm>

#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

Breaking check_breaking(lua_State* state, int index, const std::string& what, const std::vector<std::string>& parts) {
  Breaking b;
  if (lua_isnil(state, index)) return b;
  const Options o(state, index, what, parts);
  b.force = o.number_or_infinity("force", "N").value_or(b.force);
  b.torque = o.number_or_infinity("torque", "N m").value_or(b.torque);
  b.length = o.number_or_infinity("length", "m").value_or(b.length);
  return b;
}

void push_breaking(lua_State* state, const Breaking& b) {
  lua_newtable(state);
  const auto set = [&](const char* name, double value) {
    if (!std::isfinite(value)) return;
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
  };
  set("force", b.force);
  set("torque", b.torque);
  set("length", b.length);
}

std::function<double(double)> number_of_time(Callback function, std::string what, const KeptNumber& kept) {
  return CalledNumber{std::move(function), std::move(what), kept};
}

std::function<Quat(double)> quat_of_time(Callback function, std::string what) {
  return CalledTurn{std::move(function), std::move(what)};
}

NumberOrFunction check_number_of_time(const Self& self, int index, const char* what, const char* name, const char* unit,
                                      ConstraintKind of) {
  if (!lua_isfunction(self.state, index)) return {check_number(self.state, index, what, name, unit), {}};
  std::string which = name;
  if (which.back() == ',') which.pop_back();  // "argument 3, the length,"
  auto function = number_of_time(Callback(self.state, index), text(what, ": ", which), rule_of(of).keeps);
  const Lock lock(self.world);
  const double now = function(self.world.time);
  return {now, std::move(function)};
}

}  // namespace pantin::lua
