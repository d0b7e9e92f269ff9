#include "lua/thing/fields.hpp"
#include "lua/thing/picture_fields.hpp"

namespace pantin::lua {

const Type& family_type() {
  static const Type type = [] {
    Type made = type_with(fields::family_type());
    made.fields.push_back(sprite_of_family());
    add_base(made, any_set_type());
    add_common_remove(made);
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
