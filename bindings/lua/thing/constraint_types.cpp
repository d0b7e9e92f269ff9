// All kinds of constraints: what they have is in bindings/fields.
#include <vector>

#include "lua/thing/fields.hpp"

namespace pantin::lua {
namespace {

/// In the order of the kinds.
std::vector<Type> make_constraint_types() {
  std::vector<Type> types;
  for (std::size_t i = 0; i < constraint_names.size(); i++) {
    const auto kind = static_cast<ConstraintKind>(i);
    if (kind == ConstraintKind::axis) continue;  // of a hinge, and no thing of its own
    Type& type = types.emplace_back(type_with(fields::constraint_type(kind)));
    add_base(type, any_constraint_type());
    add_common_remove(type);
  }
  return types;
}

}  // namespace

const Type& any_constraint_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_constraint_type());
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}

const Type& constraint_type(Kind kind) {
  static const std::vector<Type> types = make_constraint_types();
  return types[static_cast<std::size_t>(kind) - static_cast<std::size_t>(Kind::constraint)];
}

}  // namespace pantin::lua
