// Gear, rack, pulley and screw, values in a proportion; and what slides.
#include "edit/coupling_constraints.hpp"
#include "constraints/kind.hpp"
#include "edit/constrain.hpp"
#include "fields/constraint.hpp"

namespace pantin::fields {
namespace {

const CoupledValue& first(const World& world, ConstraintId id) { return constraint_row(world, id).coupled()[0]; }
const CoupledValue& second(const World& world, ConstraintId id) { return constraint_row(world, id).coupled()[1]; }

Property carrier() {
  return property<ConstraintId>("carrier", "Body?", "", "against which it turns, or nil for the world",
                                [](const World& w, ConstraintId c) { return first(w, c).body_b; });
}

/// Of the first value, where that is an angle.
Property turned(const char* doc) {
  return property<ConstraintId>("turned", "number", "rad", doc,
                                [](const World& w, ConstraintId c) { return first(w, c).angle; });
}

}  // namespace

const Type& gear_type() {
  static const Type type = type_of_constraint(
      "Gear", "gear", "Turns one body `ratio` times as far as another.",
      {property<ConstraintId>("a", "Body", "", "its first body",
                              [](const World& w, ConstraintId c) { return first(w, c).body_a; }),
       property<ConstraintId>("b", "Body", "", "its second body",
                              [](const World& w, ConstraintId c) { return second(w, c).body_a; }),
       carrier(),
       kept_property(
           "ratio", "1",
           "turns of a for one of b, in the sense of their axes; below 0 they turn against each other, as wheels do "
           "that mesh from outside; written as a number or a function of time [s], the wheels mesh anew"),
       turned("the angle of a against the carrier, since it was made, turns counted"), torque_property()});
  return type;
}

const Type& rack_type() {
  static const Type type = type_of_constraint(
      "Rack", "rack", "Moves a point along a line as far as the rim of a wheel turns.",
      {property<ConstraintId>("wheel", "Body", "", "the body that turns",
                              [](const World& w, ConstraintId c) { return first(w, c).body_a; }),
       property<ConstraintId>("point", "Point", "", "the point that moves",
                              [](const World& w, ConstraintId c) { return second(w, c).point_a; }),
       carrier(),
       kept_property(
           "radius", "m",
           "how far the point moves for a turn of 1 rad; written as a number or a function of time [s], the teeth "
           "mesh anew"),
       turned("the angle of the wheel against the carrier, since it was made, turns counted"), force_property(),
       torque_property()});
  return type;
}

const Type& pulley_type() {
  static const Type type = type_of_constraint(
      "Pulley", "pulley", "A rope over two anchors, at most so long; one side may count several times, as in a tackle.",
      {property<ConstraintId>("a", "Point", "", "the point at its first end",
                              [](const World& w, ConstraintId c) { return first(w, c).point_a; }),
       property<ConstraintId>("b", "Point", "", "the point at its second end",
                              [](const World& w, ConstraintId c) { return second(w, c).point_a; }),
       kept_property("ratio", "1",
                     "how many times the second side counts, > 0; written as a number, after which a rope that is too "
                     "short attracts what it ties, or as a function of time [s], with which its length goes"),
       property<ConstraintId>(
           "length", "number", "m",
           "the most that a's side and ratio times b's add up to; one that is too short attracts what it ties",
           [](const World& w, ConstraintId c) { return constraint_row(w, c).as<CouplingData>().total; },
           [](World& w, ConstraintId c, double length) { set_rope_length(w, c, length); }),
       property<ConstraintId>("force", "number", "N", "tension of a's side in the last step, 0 where it is slack",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).tension; })});
  return type;
}

const Type& screw_type() {
  static const Type type = type_of_constraint(
      "Screw", "screw",
      "Moves one point along an axis of another's body by `lead` for each turn of its own body about it. How far it is "
      "along the axis counts, on both sides; something else must keep it on the axis, such as a guide or a hinge.",
      {property<ConstraintId>("a", "Point", "", "its first point",
                              [](const World& w, ConstraintId c) { return second(w, c).point_a; }),
       property<ConstraintId>("b", "Point", "", "its second point",
                              [](const World& w, ConstraintId c) { return second(w, c).point_b; }),
       kept_property(
           "lead", "m",
           "by which a goes along the axis in a turn of its body about it; written as a number or a function of "
           "time [s], the thread begins "
           "anew"),
       turned("the angle of the first body against the second, since it was made, turns counted"), force_property(),
       torque_property()});
  return type;
}

namespace {

const CouplingData& slider_data(const World& world, ConstraintId id) {
  return constraint_row(world, id).as<CouplingData>();
}

template <bool low>
Property end_of_slider(const char* doc) {
  return or_infinity(property<ConstraintId>(
      low ? "min" : "max", "number", "m", doc,
      [](const World& w, ConstraintId c) { return low ? constraint_row(w, c).low : constraint_row(w, c).high; },
      [](World& w, ConstraintId c, double value) {
        const Constraint& slider = constraint_row(w, c);
        set_ends(w, c, low ? value : slider.low, low ? slider.high : value);
      }));
}

}  // namespace

const Type& slider_type() {
  static const Type type = type_of_constraint(
      "Slider", "slider", "Keeps a point on a line that goes with a body, or stays in the world.",
      {property<ConstraintId>("point", "Point", "", "the point that slides",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).a; }),
       property<ConstraintId>("carrier", "Body?", "", "along which it slides, or nil for the world",
                              [](const World& w, ConstraintId c) { return first(w, c).body_b; }),
       property<ConstraintId>("slid", "number", "m", "how far it is along the axis now; 0 where it was made",
                              [](const World& w, ConstraintId c) { return present_value(w, constraint_row(w, c)); }),
       property<ConstraintId>(
           "length", "number", "m",
           "how far along the axis it is kept, or of one that slides freely is; written as a number or a function of "
           "time [s] it is kept there from then on, and drawn to where that is",
           [](const World& w, ConstraintId c) {
             return slider_data(w, c).given ? constraint_row(w, c).number.now : present_value(w, constraint_row(w, c));
           },
           [](World& w, ConstraintId c, const OfTime<double>& given) {
             set_length(w, c, now(w, given), function_of(given));
           }),
       end_of_slider<true>("least way along the axis; -math.huge: none"),
       end_of_slider<false>("greatest way along the axis; math.huge: none"), force_property(), torque_property()});
  return type;
}

}  // namespace pantin::fields
