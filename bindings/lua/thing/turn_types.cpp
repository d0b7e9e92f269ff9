// Weld, orient, align, motor and limit.
#include "constraints/kind.hpp"
#include "lua/thing/constraint_fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

const Field body_a = {"a",    "Body", "", "its first body", [](const Self& s) { push_if(s, constraint_row(s).body_a); },
                      nullptr};
const Field body_b = {"b",
                      "Body?",
                      "",
                      "its second body, or nil for the world",
                      [](const Self& s) { push_if(s, constraint_row(s).body_b); },
                      nullptr};

/// A field that is a number, or a function of time where it is written.
template <int of_speed>
Field number_field(const char* name, const char* unit, const char* doc) {
  return {name,
          "number",
          unit,
          doc,
          [](const Self& s) {
            const Constraint& c = constraint_row(s);
            lua_pushnumber(s.state, of_speed ? c.length_rate : c.length);
          },
          [](const Self& s, int i) {
            const bool by_speed = constraint_row(s).by_speed;
            require(by_speed == (of_speed != 0), type_of(s.ref.kind).word, ": this one keeps its ",
                    by_speed ? "speed" : "angle", "; make another to keep its ", by_speed ? "angle" : "speed");
            auto given = check_number_of_time(s, i, type_of(s.ref.kind).word, of_speed ? "speed" : "angle",
                                              of_speed ? "rad/s" : "rad");
            set_length(s.world, constraint_of(s), given.value, std::move(given.function));
          }};
}

template <bool low>
Field range_field(const char* name, const char* doc) {
  return {name,
          "number",
          "rad or m",
          doc,
          [](const Self& s) { lua_pushnumber(s.state, low ? constraint_row(s).low : constraint_row(s).high); },
          [](const Self& s, int i) {
            const double value = check_number_or_infinity(s.state, i, "limit", low ? "min" : "max", "rad or m");
            const Constraint& c = constraint_row(s);
            set_range(s.world, constraint_of(s), low ? value : c.low, low ? c.high : value);
          }};
}

Type make_weld() {
  return constraint_type({"Weld", "weld", "Keeps two bodies in their relative position and orientation.", {}, {}},
                         {body_a, body_b, force_field(), torque_field()});
}

Type make_orient() {
  return constraint_type({"Orient", "orient", "Keeps the orientation of a body.", {}, {}},
                         {body_a,
                          {"to", "quat", "",
                           "the orientation; written as a quat or a function of time [s]; the "
                           "body is drawn to a new one",
                           [](const Self& s) { push(s.state, constraint_row(s).turn); },
                           [](const Self& s, int i) {
                             if (!lua_isfunction(s.state, i))
                               return set_attitude(s.world, constraint_of(s), check_quat(s.state, i, "orient", "to"));
                             auto function = quat_of_time(Callback(s.state, i), "orient: to");
                             Quat now;
                             {
                               const Lock lock(s.world);
                               now = function(s.world.time);
                             }
                             set_attitude(s.world, constraint_of(s), now, std::move(function));
                           }},
                          torque_field()});
}

Type make_align() {
  return constraint_type(
      {"Align", "align", "Keeps the angle between an axis of a body and one of another.", {}, {}},
      {body_a, body_b,
       number_field<0>("angle", "rad", "the angle, 0 to π; written as a number or a function of time [s]"),
       torque_field()});
}

Type make_motor() {
  return constraint_type(
      {"Motor", "motor", "Turns a body about an axis, against another or the world.", {}, {}},
      {body_a,
       body_b,
       number_field<1>("speed", "rad/s",
                       "of a against b, where it keeps that; a number or a function of time [s]; a step, "
                       "or a sub-step, turns by 2 atan(speed step / 2), as it turns what spins freely"),
       number_field<0>("angle", "rad", "that it keeps, where it does; a number or a function of time [s]"),
       {"turned", "number", "rad", "the angle of a against b now, turns counted",
        [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).angle); }, nullptr},
       {"max_torque", "number", "N m", "never pushes harder; math.huge: no limit",
        [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).max_torque); },
        [](const Self& s, int i) {
          set_max_torque(s.world, constraint_of(s), check_number_or_infinity(s.state, i, "motor", "max_torque", "N m"));
        }},
       torque_field()});
}

Type make_limit() {
  return constraint_type(
      {"Limit", "limit", "Keeps an angle about an axis, or a distance, in a range.", {}, {}},
      {range_field<true>("min", "least angle or distance; -math.huge: none"),
       range_field<false>("max", "greatest angle or distance; math.huge: none"),
       {"value", "number", "rad or m", "the angle or distance now",
        [](const Self& s) { lua_pushnumber(s.state, present_value(s.world, constraint_row(s))); }, nullptr},
       force_field(),
       torque_field()});
}

}  // namespace

const Type& weld_type() {
  static const Type type = make_weld();
  return type;
}
const Type& orient_type() {
  static const Type type = make_orient();
  return type;
}
const Type& align_type() {
  static const Type type = make_align();
  return type;
}
const Type& motor_type() {
  static const Type type = make_motor();
  return type;
}
const Type& limit_type() {
  static const Type type = make_limit();
  return type;
}
}  // namespace pantin::lua
