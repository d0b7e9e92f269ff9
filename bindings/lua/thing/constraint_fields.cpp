#include "lua/thing/constraint_fields.hpp"

#include <algorithm>

#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {

ConstraintId constraint_of(const Self& self) { return self.ref.id<ConstraintId>(); }
Constraint& constraint_row(const Self& self) { return self.world.constraints[constraint_of(self)]; }

Type constraint_type(Type type, std::vector<Field> fields) {
  type.fields = std::move(fields);
  add_base(type, any_constraint_type());
  add_common_remove(type);
  return type;
}

Field point_field() {
  return {"point", "Point", "", "the point that it holds", [](const Self& s) { push_if(s, constraint_row(s).a); },
          nullptr};
}

Field force_field() {
  return {"force",
          "vec",
          "N",
          "what it exerted on its first point in the last step",
          [](const Self& s) { push(s.state, constraint_row(s).force); },
          nullptr};
}

Field torque_field() {
  return {
      "torque",
      "vec",
      "N m",
      "what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass",
      [](const Self& s) { push(s.state, constraint_row(s).torque); },
      nullptr};
}

Breaking check_breaking(lua_State* state, int index, const std::string& what, bool has_length) {
  Breaking b;
  if (lua_isnil(state, index)) return b;
  std::vector<std::string> names = {"force", "torque"};
  if (has_length) names.push_back("length");
  const Options o(state, index, what, names);
  b.force = o.number_or_infinity("force", "N").value_or(b.force);
  b.torque = o.number_or_infinity("torque", "N m").value_or(b.torque);
  if (has_length) b.length = o.number_or_infinity("length", "m").value_or(b.length);
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

namespace {

Field enabled_field() {
  return {"enabled",
          "boolean",
          "",
          "whether it acts (default `true`)",
          [](const Self& s) { lua_pushboolean(s.state, constraint_row(s).enabled); },
          [](const Self& s, int i) {
            set_enabled(s.world, constraint_of(s), check_boolean(s.state, i, type_of(s.ref.kind).word, "enabled"));
          }};
}

Field breaks_at_field() {
  return {"breaks_at",
          "Breaking",
          "",
          "load or length at which it breaks, within a step where it passes that; a weld's torque is about the middle "
          "between the two centres of mass (default `{}`)",
          [](const Self& s) { push_breaking(s.state, constraint_row(s).breaks_at); },
          [](const Self& s, int i) {
            const std::string what = std::string(type_of(s.ref.kind).word) + ": breaks_at";
            set_breaks_at(s.world, constraint_of(s), check_breaking(s.state, i, what));
          }};
}

}  // namespace

const Type& any_constraint_type() {
  static const Type type = [] {
    Type made{"AnyConstraint", "constraint", "What every constraint has.", {breaks_at_field(), enabled_field()}, {}};
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}

std::function<double(double)> number_of_time(Callback function, std::string what) {
  return [function = std::move(function), what = std::move(what)](double time) {
    double value = 0.0;
    function.call(
        [&](lua_State* state) {
          lua_pushnumber(state, time);
          return 1;
        },
        [&](lua_State* state) { value = check_number(state, -1, what, "its result", ""); });
    return value;
  };
}

std::function<Quat(double)> quat_of_time(Callback function, std::string what) {
  return [function = std::move(function), what = std::move(what)](double time) {
    Quat value;
    function.call(
        [&](lua_State* state) {
          lua_pushnumber(state, time);
          return 1;
        },
        [&](lua_State* state) { value = check_quat(state, -1, what, "its result"); });
    return value;
  };
}

NumberOrFunction check_number_of_time(const Self& self, int index, const char* what, const char* name,
                                      const char* unit) {
  if (!lua_isfunction(self.state, index)) return {check_number(self.state, index, what, name, unit), {}};
  auto function = number_of_time(Callback(self.state, index), std::string(what) + ": " + name);
  const Lock lock(self.world);
  const double now = function(self.world.time);
  return {now, std::move(function)};
}

}  // namespace pantin::lua
