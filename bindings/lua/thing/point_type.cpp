#include "lua/thing/fields.hpp"
#include "lua/thing/pushes.hpp"

namespace pantin::lua {
namespace {

Type make_point_type() {
  Type type = type_with(fields::point_type());
  type.methods = pushes<Kind::point>();
  add_base(type, any_thing_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& point_type() {
  static const Type type = make_point_type();
  return type;
}

}  // namespace pantin::lua
