#include <string_view>

#include "lua/thing/fields.hpp"
#include "lua/thing/ground_options.hpp"
#include "lua/thing/picture_fields.hpp"
#include "lua/thing/script.hpp"

namespace pantin::lua {
namespace {

bool refuse_motion(const Self& self, const char* name, int) {
  const std::string_view field = name;
  if (field != "velocity" && field != "spin") return false;
  const BodyId body = self.world.shapes[std::get<ShapeId>(self.ref.thing)].body;
  throw Error(
      text("collider: it has no '", field, "'. ", body ? "It moves with its body, collider.body" : stands_still));
}

}  // namespace

const Type& collider_type() {
  static const Type type = [] {
    Type made = type_with(fields::collider_type());
    made.fields.push_back(picture_of_collider());
    add_base(made, any_thing_type());
    add_common_remove(made);
    made.write_more = refuse_motion;
    return made;
  }();
  return type;
}

}  // namespace pantin::lua
