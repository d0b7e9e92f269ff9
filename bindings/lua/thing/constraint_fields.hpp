#pragma once
// Fields that constraints share.
#include "edit/constrain.hpp"
#include "lua/thing/fields.hpp"
#include "lua/value/callback.hpp"

namespace pantin::lua {

ConstraintId constraint_of(const Self& self);
Constraint& constraint_row(const Self& self);
/// Pushes a thing, or nil where the id is null.
template <class Id>
void push_if(const Self& self, Id id) {
  if (id)
    push_thing(self.state, self.script, id);
  else
    lua_pushnil(self.state);
}

/// The type with these fields and those that every constraint has.
Type constraint_type(Type type, std::vector<Field> fields);
Field point_field();   ///< that it holds
Field force_field();   ///< as a vec
Field torque_field();  ///< as a vec
/// { force, torque, length } at `index`, for `what`.
Breaking check_breaking(lua_State* state, int index, const std::string& what, bool has_length = true);
void push_breaking(lua_State* state, const Breaking& breaks_at);

/// A script's functions of time [s].
std::function<double(double)> number_of_time(Callback function, std::string what);
std::function<Quat(double)> quat_of_time(Callback function, std::string what);

/// A number, or a function of time with its present value.
struct NumberOrFunction {
  double value = 0.0;
  std::function<double(double)> function;
};
NumberOrFunction check_number_of_time(const Self& self, int index, const char* what, const char* name,
                                      const char* unit);

}  // namespace pantin::lua
