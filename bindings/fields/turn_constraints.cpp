// Weld, orient, align, motor and limit: what ties rotations.
#include "constraints/kind.hpp"
#include "edit/constrain.hpp"
#include "fields/constraint.hpp"

namespace pantin::fields {
namespace {

Property body_a() {
  return property<ConstraintId>("a", "Body", "", "its first body",
                                [](const World& w, ConstraintId c) { return constraint_row(w, c).body_a; });
}
Property body_b() {
  return property<ConstraintId>("b", "Body?", "", "its second body, or nil for the world",
                                [](const World& w, ConstraintId c) { return constraint_row(w, c).body_b; });
}

/// The angle that a motor or an align keeps, or the speed that a motor does.
template <bool of_speed>
Property kept_number(const char* doc) {
  return property<ConstraintId>(
      of_speed ? "speed" : "angle", "number", of_speed ? "rad/s" : "rad", doc,
      [](const World& w, ConstraintId c) {
        return of_speed ? constraint_row(w, c).number.rate : constraint_row(w, c).number.now;
      },
      [](World& w, ConstraintId c, const OfTime<double>& given) {
        const bool by_speed = constraint_row(w, c).by_speed;
        require(by_speed == of_speed, constraint_type(constraint_row(w, c).kind).word, ": this one keeps its ",
                by_speed ? "speed" : "angle", "; make another to keep its ", by_speed ? "angle" : "speed");
        set_length(w, c, now(w, given), function_of(given));
      });
}

template <bool low>
Property end_of_range(const char* doc) {
  return or_infinity(property<ConstraintId>(
      low ? "min" : "max", "number", "rad or m", doc,
      [](const World& w, ConstraintId c) { return low ? constraint_row(w, c).low : constraint_row(w, c).high; },
      [](World& w, ConstraintId c, double value) {
        const Constraint& constraint = constraint_row(w, c);
        set_range(w, c, low ? value : constraint.low, low ? constraint.high : value);
      }));
}

}  // namespace

const Type& weld_type() {
  static const Type type =
      type_of_constraint("Weld", "weld", "Keeps two bodies in their relative position and orientation.",
                         {body_a(), body_b(), force_property(), torque_property()});
  return type;
}

const Type& orient_type() {
  static const Type type =
      type_of_constraint("Orient", "orient", "Keeps the orientation of a body.",
                         {body_a(),
                          property<ConstraintId>(
                              "to", "quat", "",
                              "the orientation; written as a quat or a function of time [s]; the "
                              "body is drawn to a new one",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).turn.now; },
                              [](World& w, ConstraintId c, const OfTime<Quat>& given) {
                                set_attitude(w, c, now(w, given), function_of(given));
                              }),
                          torque_property()});
  return type;
}

const Type& align_type() {
  static const Type type = type_of_constraint(
      "Align", "align", "Keeps the angle between an axis of a body and one of another.",
      {body_a(), body_b(), kept_number<false>("the angle, 0 to π; written as a number or a function of time [s]"),
       torque_property()});
  return type;
}

const Type& motor_type() {
  static const Type type = type_of_constraint(
      "Motor", "motor", "Turns a body about an axis, against another or the world.",
      {body_a(), body_b(),
       kept_number<true>("of a against b, where it keeps that; a number or a function of time [s]; a step, "
                         "or a sub-step, turns by 2 atan(speed step / 2), as it turns what spins freely"),
       kept_number<false>("that it keeps, where it does; a number or a function of time [s]"),
       property<ConstraintId>("turned", "number", "rad", "the angle of a against b now, turns counted",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).angle; }),
       or_infinity(property<ConstraintId>(
           "max_torque", "number", "N m", "never pushes harder; math.huge: no limit",
           [](const World& w, ConstraintId c) { return constraint_row(w, c).max_torque; },
           [](World& w, ConstraintId c, double torque) { set_max_torque(w, c, torque); })),
       torque_property()});
  return type;
}

const Type& limit_type() {
  static const Type type = type_of_constraint(
      "Limit", "limit", "Keeps an angle about an axis, or a distance, in a range.",
      {end_of_range<true>("least angle or distance; -math.huge: none"),
       end_of_range<false>("greatest angle or distance; math.huge: none"),
       property<ConstraintId>("value", "number", "rad or m", "the angle or distance now",
                              [](const World& w, ConstraintId c) { return present_value(w, constraint_row(w, c)); }),
       force_property(), torque_property()});
  return type;
}

}  // namespace pantin::fields
