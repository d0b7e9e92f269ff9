#include "fields/constraint.hpp"

#include "edit/constrain.hpp"

namespace pantin::fields {
namespace {

std::vector<Property> of_any_constraint() {
  return {
      of_parts({"force", "torque", "length"},
               property<ConstraintId>(
                   "breaks_at", "Breaking", "",
                   "load or length at which it breaks, within a step where it passes that; of a blow or a "
                   "push that is far too much it bears nothing; a weld's "
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
  static const Type type = {"AnyConstraint", "constraint", "What every constraint has.", of_any_constraint(),
                            &any_thing_type()};
  return type;
}

Type type_of_constraint(const char* name, const char* word, const char* doc, std::vector<Property> properties) {
  return {name, word, doc, std::move(properties), &any_constraint_type()};
}

Property point_property() {
  return property<ConstraintId>("point", "Point", "", "the point that it holds",
                                [](const World& w, ConstraintId c) { return w.constraints[c].a; });
}

Property kept_property(const char* name, const char* unit, const char* doc) {
  return property<ConstraintId>(
      name, "number", unit, doc, [](const World& w, ConstraintId c) { return constraint_row(w, c).number.now; },
      [](World& w, ConstraintId c, const OfTime<double>& given) {
        set_length(w, c, now(w, given), function_of(given));
      });
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

/// An axis is of a hinge, and no thing of its own.
const Type& axis_type() { return any_constraint_type(); }

const Type& constraint_type(ConstraintKind kind) {
  using Maker = const Type& (*)();
  // (kinds)
  constexpr Maker types[] = {
#define CONSTRAINT_KIND(name) name##_type,
#include "model/constraint_kinds.hpp"
  };
  return types[static_cast<std::size_t>(kind)]();
}

}  // namespace pantin::fields
