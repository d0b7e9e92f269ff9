// On_plane, string and on_path: where points may go.
#include "constraints/kind.hpp"
#include "edit/constrain.hpp"
#include "fields/constraint.hpp"
#include "model/path.hpp"

namespace pantin::fields {
namespace {

Table passages(const World& world, ConstraintId id) {
  Table list;
  for (const Passage& passage : constraint_row(world, id).passages())
    list.push_back({"", passage.point ? Value(AnyId(passage.point)) : Value(passage.position)});
  return list;
}

Table places(const World& world, ConstraintId id) {
  Table list;
  for (const Vec3& place : constraint_row(world, id).as<PathData>().path->positions()) list.push_back({"", place});
  return list;
}

}  // namespace

const Type& on_plane_type() {
  static const Type type =
      type_of_constraint("OnPlane", "on_plane", "Keeps a point on a plane.",
                         {point_property(),
                          property<ConstraintId>(
                              "through", "vec", "m", "a position on the plane; the point is drawn to a new one",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).position.now; },
                              [](World& w, ConstraintId c, Vec3 at) { set_position(w, c, at); }),
                          property<ConstraintId>(
                              "normal", "vec", "1", "across the plane, of unit length",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).axis_a; },
                              [](World& w, ConstraintId c, Vec3 normal) {
                                change_constraint(w, c, "normal", [&](Constraint& plane) { plane.axis_a = normal; });
                              }),
                          force_property()});
  return type;
}

const Type& string_type() {
  static const Type type = type_of_constraint(
      "String", "string", "Is at most so long along its points; slides through the inner ones.",
      {property<ConstraintId>("points", "(Point|vec)[]", "m", "what it goes through: points, or positions",
                              [](const World& w, ConstraintId c) { return passages(w, c); }),
       property<ConstraintId>(
           "length", "number", "m",
           "the most that it is long; written as a number or a function of time "
           "[s]",
           [](const World& w, ConstraintId c) { return constraint_row(w, c).number.now; },
           [](World& w, ConstraintId c, const OfTime<double>& given) {
             set_length(w, c, now(w, given), function_of(given));
           }),
       property<ConstraintId>("taken", "number", "m", "how long its way is now: less than its length where it is slack",
                              [](const World& w, ConstraintId c) { return present_value(w, constraint_row(w, c)); }),
       property<ConstraintId>("force", "number", "N", "tension in the last step, 0 where it is slack",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).tension; })});
  return type;
}

const Type& on_path_type() {
  static const Type type = type_of_constraint(
      "OnPath", "on_path", "Keeps a point on a path.",
      {point_property(),
       property<ConstraintId>("path", "vec[]", "m", "the positions that the path goes through",
                              [](const World& w, ConstraintId c) { return places(w, c); }),
       property<ConstraintId>("along", "number", "1",
                              "where on the path the point is: 0 at the first position, 1 at the "
                              "second, and so on",
                              [](const World& w, ConstraintId c) { return constraint_row(w, c).as<PathData>().along; }),
       force_property()});
  return type;
}

}  // namespace pantin::fields
