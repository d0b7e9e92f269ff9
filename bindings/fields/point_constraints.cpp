// Nail, follow, rod and join: between points.
#include "edit/constrain.hpp"
#include "fields/constraint.hpp"

namespace pantin::fields {
namespace {

/// A vec that a constraint keeps a point to.
Property position_property(const char* name, const char* doc) {
  return property<ConstraintId>(
      name, "vec", "m", doc, [](const World& w, ConstraintId c) { return constraint_row(w, c).position.now; },
      [](World& w, ConstraintId c, Vec3 at) { set_position(w, c, at); });
}

Property target() {
  return property<ConstraintId>(
      "target", "vec", "m", "where the target is; written as a vec or a function of time [s]",
      [](const World& w, ConstraintId c) { return constraint_row(w, c).position.now; },
      [](World& w, ConstraintId c, const OfTime<Vec3>& given) {
        if (auto function = function_of(given))
          set_target(w, c, std::move(function));
        else
          set_position(w, c, std::get<Vec3>(given));
      });
}

Property end_of_rod() {
  return property<ConstraintId>(
      "at", "vec", "m", "position of its second end; written where no point is there",
      [](const World& w, ConstraintId c) {
        return constraint_row(w, c).b ? position(w, constraint_row(w, c).b) : constraint_row(w, c).position.now;
      },
      [](World& w, ConstraintId c, Vec3 at) {
        require(!constraint_row(w, c).b,
                "rod: at can be written only of a rod whose end is a position; this one ends at a point");
        set_position(w, c, at);
      });
}

Property first_point(const char* doc) {
  return property<ConstraintId>("a", "Point", "", doc,
                                [](const World& w, ConstraintId c) { return constraint_row(w, c).a; });
}
Property second_point(const char* type, const char* doc) {
  return property<ConstraintId>("b", type, "", doc,
                                [](const World& w, ConstraintId c) { return constraint_row(w, c).b; });
}

}  // namespace

const Type& nail_type() {
  static const Type type = type_of_constraint(
      "Nail", "nail", "Keeps a point at a position of the world.",
      {point_property(), position_property("at", "the position; the point is drawn to a new one"), force_property()});
  return type;
}

const Type& follow_type() {
  static const Type type =
      type_of_constraint("Follow", "follow",
                         "Keeps a point to a moving target; with max_force as a spring and damper of its "
                         "time_constant, and never harder: a weight hangs g time_constant^2 lower.",
                         {point_property(), target(),
                          or_infinity(property<ConstraintId>(
                              "max_force", "number", "N", "never pulls harder; math.huge: no limit",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).max_force; },
                              [](World& w, ConstraintId c, double force) { set_max_force(w, c, force); })),
                          force_property()});
  return type;
}

const Type& rod_type() {
  static const Type type = type_of_constraint(
      "Rod", "rod", "Keeps two points, or a point and a position, at a distance.",
      {first_point("its first point"), second_point("Point?", "its second point, or nil where that end is a position"),
       end_of_rod(),
       kept_property("length", "m", "the distance that it keeps; written as a number or a function of time [s]"),
       property<ConstraintId>("force", "number", "N", "tension in the last step, > 0 when it pulls",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).tension; })});
  return type;
}

const Type& join_type() {
  static const Type type = type_of_constraint(
      "Join", "join", "Draws two points together, to join them into a hinge.",
      {first_point("the first point"), second_point("Point", "the second point"),
       property<ConstraintId>("max_force", "number", "N", "it never pulls harder; math.huge: no limit",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).max_force; }),
       force_property()});
  return type;
}

}  // namespace pantin::fields
