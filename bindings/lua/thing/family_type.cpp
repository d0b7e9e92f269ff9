#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

FamilyId id_of(const Self& self) { return self.ref.id<FamilyId>(); }
const Family& row(const Self& self) { return self.world.families[id_of(self)]; }

void read_attributes(const Self& self) {
  lua_newtable(self.state);
  for (const Family::Attribute& a : row(self).attributes) {
    lua_pushnumber(self.state, a.value);
    lua_setfield(self.state, -2, a.name.c_str());
  }
}

Type make() {
  Type type{"Family", "family", "Particles of a kind, with named numeric attributes that laws read.", {}, {}};
  type.fields = {
      {"attributes", "table<string, number>", "each its own", "values of a particle that gives none", read_attributes,
       nullptr},
      {"particles", "Particle[]", "", "its living particles, in the order of making",
       [](const Self& s) { push_list(s.state, s.script, particles(s.world, id_of(s))); }, nullptr},
  };
  add_base(type, any_set_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& family_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
