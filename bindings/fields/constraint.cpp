#include "fields/constraint.hpp"

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
  switch (kind) {
    case ConstraintKind::nail: return nail_type();
    case ConstraintKind::follow: return follow_type();
    case ConstraintKind::rod: return rod_type();
    case ConstraintKind::weld: return weld_type();
    case ConstraintKind::orient: return orient_type();
    case ConstraintKind::align: return align_type();
    case ConstraintKind::motor: return motor_type();
    case ConstraintKind::limit: return limit_type();
    case ConstraintKind::on_plane: return on_plane_type();
    case ConstraintKind::string: return string_type();
    case ConstraintKind::on_path: return on_path_type();
    case ConstraintKind::join: return join_type();
    case ConstraintKind::axis: break;  // of a hinge, and no thing of its own
  }
  return any_constraint_type();
}

}  // namespace pantin::fields
