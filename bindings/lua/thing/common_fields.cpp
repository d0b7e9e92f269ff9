// `name`, `alive`, `data`, `remove`: what every thing has.
#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/property_values.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// Of what is gone, too, while that is not forgotten.
void read_name(const Self& self) {
  try {
    push_value(self.state, self.script, fields::any_thing_type().properties.front().read(self.world, self.ref.thing));
  } catch (const Error&) {
    require_alive(self.ref);
    throw;
  }
}

/// Of what is gone while that is told.
void read_data(const Self& self) {
  if (self.ref.thing != self.script.told_of) require_alive(self.ref);
  push_data(self.state, self.ref);
}

void read_class(const Self& self) { lua_pushstring(self.state, type_of(self.ref.kind).name); }

int remove_thing(lua_State* state) {
  const Ref* ref = to_ref(state, 1);
  require(ref, "remove: call it with a colon, thing:remove()");
  require_alive(*ref);
  remove(ref->script->world, ref->thing);
  return 0;
}

}  // namespace

const Type& any_thing_type() {
  static const Type type = [] {
    Type made = type_with(fields::any_thing_type());
    made.fields.push_back(
        {"data", "table", "",
         "a table of yours, which goes with the thing, and is there still while its end is told (default `{}`)",
         read_data, nullptr, true});
    made.fields.push_back({"class", "string", "",
                           "what it is, as it is called here: `if touch.b.class == \"Collider\" then … end`",
                           read_class, nullptr, true});
    field_named(made, "name").read = read_name;
    made.methods = {{"remove", guard<remove_thing>, "", "", "Takes it out of the world.",
                     "scene:after(2, function() p:remove() end)"}};
    return made;
  }();
  return type;
}

void add_base(Type& type, const Type& base) {
  type.base = &base;
  for (const Type* more = &base; more; more = more->base)
    type.fields.insert(type.fields.end(), more->fields.begin(), more->fields.end());
}

void add_common_remove(Type& type) { type.methods.push_back(any_thing_type().methods.front()); }

}  // namespace pantin::lua
