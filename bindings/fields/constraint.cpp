#include "fields/constraint.hpp"

#include <iterator>

#include "edit/constrain.hpp"

namespace pantin::fields {
namespace {

std::vector<Property> common() {
  return {
      of_parts({"force", "torque", "length"},
               property<ConstraintId>(
                   "breaks_at", "Breaking", "",
                   "load or length at which it breaks, within a step where it passes that; a weld's "
                   "torque is about the middle "
                   "between the two centres of mass (default `{}`)",
                   [](const World& w, ConstraintId c) { return w.constraints[c].breaks_at; },
                   [](World& w, ConstraintId c, const Breaking& b) { set_breaks_at(w, c, b); })),
      property<ConstraintId>(
          "enabled", "boolean", "", "whether it acts (default `true`)",
          [](const World& w, ConstraintId c) { return w.constraints[c].enabled; },
          [](World& w, ConstraintId c, bool on) { set_enabled(w, c, on); }),
  };
}

}  // namespace

const Type& any_constraint_type() {
  static const Type type = {"AnyConstraint", "constraint", "What every constraint has.", common(), &any_thing_type()};
  return type;
}

Type type_of_constraint(const char* name, const char* word, const char* doc, std::vector<Property> properties) {
  return {name, word, doc, std::move(properties), &any_constraint_type()};
}

Property point_property() {
  return property<ConstraintId>("point", "Point", "", "the point that it holds",
                                [](const World& w, ConstraintId c) { return w.constraints[c].a; });
}

Property force_property() {
  return property<ConstraintId>("force", "vec", "N", "what it exerted on its first point in the last step",
                                [](const World& w, ConstraintId c) { return w.constraints[c].force; });
}

Property torque_property() {
  return property<ConstraintId>(
      "torque", "vec", "N m",
      "what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass",
      [](const World& w, ConstraintId c) { return w.constraints[c].torque; });
}

const Type& constraint_type(ConstraintKind kind) {
  using Maker = const Type& (*)();
  // (kinds) in the order of ConstraintKind; an axis is of a hinge, and no thing of its own
  constexpr Maker types[] = {nail_type,  follow_type, rod_type,   any_constraint_type, weld_type,   orient_type,
                             align_type, motor_type,  limit_type, on_plane_type,       string_type, on_path_type,
                             join_type,  gear_type,   rack_type,  pulley_type,         screw_type};
  static_assert(std::size(types) == constraint_names.size());
  return types[static_cast<std::size_t>(kind)]();
}

}  // namespace pantin::fields
