#pragma once
// What constraints are given: loads that they break at, functions of time.
#include "constraints/kind.hpp"
#include "edit/constrain.hpp"
#include "lua/thing/fields.hpp"
#include "lua/value/callback.hpp"

namespace pantin::lua {

/// { force, torque, length } at `index`, or those of them that are in `parts`, for `what`.
Breaking check_breaking(lua_State* state, int index, const std::string& what,
                        const std::vector<std::string>& parts = {"force", "torque", "length"});
void push_breaking(lua_State* state, const Breaking& breaks_at);

/// A script's functions of time [s]; of numbers that a constraint may keep.
std::function<double(double)> number_of_time(Callback function, std::string what, const KeptNumber& kept = {});
std::function<Quat(double)> quat_of_time(Callback function, std::string what);

/// A number, or a function of time with its present value.
struct NumberOrFunction {
  double value = 0.0;
  std::function<double(double)> function;
};
NumberOrFunction check_number_of_time(const Self& self, int index, const char* what, const char* name, const char* unit,
                                      ConstraintKind of);

}  // namespace pantin::lua
