// String and on_path: where points may go.
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

const Type& string_type() {
  static const Type type = type_of_constraint(
      "String", "string", "Is at most so long along its points; slides through the inner ones.",
      {fixed(property<ConstraintId>("points", "(Point|vec)[]", "m", "what it goes through: points, or positions",
                                    [](const World& w, ConstraintId c) { return passages(w, c); })),
       kept_property(
           "length", "m",
           "the most that it is long; written as a number or a function of time [s]. One that is written longer "
           "becomes so evenly in the step after"),
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
       fixed(property<ConstraintId>("path", "vec[]", "m", "the positions that the path goes through",
                                    [](const World& w, ConstraintId c) { return places(w, c); })),
       property<ConstraintId>(
           "along", "number", "1",
           "where on the path the point is: 0 at the first position, 1 at the "
           "second, and so on; of a closed path it goes on counting beyond the last, and back below 0, round "
           "after round",
           [](const World& w, ConstraintId c) { return constraint_row(w, c).as<PathData>().along; }),
       force_property()});
  return type;
}

}  // namespace pantin::fields
