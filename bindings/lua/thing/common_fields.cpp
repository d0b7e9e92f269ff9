// `name`, `alive`, `data`, `remove`: what every thing has.
#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// The place of a thing's name in its row; null for what has none.
std::string* name_of(const Self& self) {
  World& w = self.world;
  if (is_constraint(self.ref.kind)) return &w.constraints[self.ref.id<ConstraintId>()].name;
  switch (self.ref.kind) {
    case Kind::point: return &w.points[self.ref.id<PointId>()].name;
    case Kind::particle: return &w.particles[self.ref.id<ParticleId>()].name;
    case Kind::body: return &w.bodies[self.ref.id<BodyId>()].name;
    case Kind::group: return &w.groups[self.ref.id<GroupId>()].name;
    case Kind::family: return &w.families[self.ref.id<FamilyId>()].name;
    case Kind::connection: return &w.connections[self.ref.id<ConnectionId>()].name;
    case Kind::interaction: return &w.interactions[self.ref.id<InteractionId>()].name;
    case Kind::field: return &w.fields[self.ref.id<FieldId>()].name;
    case Kind::emitter: return &w.emitters[self.ref.id<EmitterId>()].name;
    default: return nullptr;
  }
}

void read_name(const Self& self) {
  const std::string& name = *name_of(self);
  lua_pushlstring(self.state, name.data(), name.size());
}

void write_name(const Self& self, int index) {
  const std::string name = check_text(self.state, index, type_of(self.ref.kind).word, "name");
  require(self.ref.kind != Kind::point || !self.world.points[self.ref.id<PointId>()].body,
          "point: name of a body's point is given with the body and stays");
  *name_of(self) = name;
}

void read_alive(const Self& self) { lua_pushboolean(self.state, alive(self.ref)); }
void read_data(const Self& self) { push_data(self.state, self.ref); }

int remove_thing(lua_State* state) {
  const Ref* ref = to_ref(state, 1);
  require(ref, "remove: call it with a colon, thing:remove()");
  require_alive(*ref);
  remove(ref->script->world, any_of(*ref));
  return 0;
}

}  // namespace

const Type& any_thing_type() {
  static const Type type = {
      "AnyThing",
      "thing",
      "What every thing has; it may be a target of events and behaviours, and a member of a group.",
      {{"name", "string", "", "what messages and scene:find call it (default `\"\"`)", read_name, write_name},
       {"alive", "boolean", "", "whether it still exists", read_alive, nullptr, true},
       {"data", "table", "", "a table of yours, which goes with the thing (default `{}`)", read_data, nullptr}},
      {{"remove", guard<remove_thing>, "", "", "Takes it out of the world.",
        "scene:after(2, function() p:remove() end)"}}};
  return type;
}

void add_base(Type& type, const Type& base) {
  type.base = &base;
  for (const Type* more = &base; more; more = more->base)
    type.fields.insert(type.fields.end(), more->fields.begin(), more->fields.end());
}

void add_common_remove(Type& type) { type.methods.push_back(any_thing_type().methods.front()); }

}  // namespace pantin::lua
