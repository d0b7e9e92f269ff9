#include "lua/thing/fields.hpp"

namespace pantin::lua {

const Type& collider_type() {
  static const Type type = [] {
    Type made = type_with(fields::collider_type());
    add_base(made, any_thing_type());
    add_common_remove(made);
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
