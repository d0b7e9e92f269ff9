#include "edit/constrain.hpp"
#include "fields/constraint.hpp"

namespace pantin::fields {

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

}  // namespace pantin::fields
