// Connection, interaction and field: what makes laws act.
#include "lua/thing/fields.hpp"
#include "lua/thing/law_parameters.hpp"

namespace pantin::lua {
namespace {

void read_parameters(const Self& self) { push_law_parameters(self.state, self.ref); }

Type make(const fields::Type& properties) {
  Type type = type_with(properties);
  add_base(type, any_force_element_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& any_force_element_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_force_element_type());
    field_named(made, "parameters").read = read_parameters;
    field_named(made, "energy").read = read_energy;
    made.base = &any_thing_type();
    return made;
  }();
  return type;
}
const Type& connection_type() {
  static const Type type = make(fields::connection_type());
  return type;
}
const Type& interaction_type() {
  static const Type type = make(fields::interaction_type());
  return type;
}
const Type& field_type() {
  static const Type type = make(fields::field_type());
  return type;
}

}  // namespace pantin::lua
