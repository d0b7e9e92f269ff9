#include <limits>

#include "lua/thing/emitter_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {
namespace {

EmitterId id_of(const Self& self) { return self.ref.id<EmitterId>(); }
const Emitter& row(const Self& self) { return self.world.emitters[id_of(self)]; }

void read_place(const Self& self) {
  const Emitter& e = row(self);
  if (e.point) return push_thing(self.state, self.script, self.world.points.alive(e.point) ? AnyId(e.point) : AnyId());
  if (norm2(e.upper - e.lower) == 0.0) return push(self.state, e.lower);
  lua_createtable(self.state, 2, 0);
  push(self.state, e.lower);
  lua_rawseti(self.state, -2, 1);
  push(self.state, e.upper);
  lua_rawseti(self.state, -2, 2);
}

void read_lifetime(const Self& self) {
  const Emitter& e = row(self);
  if (e.shortest == e.longest) return lua_pushnumber(self.state, e.shortest);
  lua_createtable(self.state, 0, 2);
  lua_pushnumber(self.state, e.shortest);
  lua_setfield(self.state, -2, "min");
  lua_pushnumber(self.state, e.longest);
  lua_setfield(self.state, -2, "max");
}

void write_rate(const Self& self, int index) {
  if (lua_isfunction(self.state, index)) return set_rate(self.world, id_of(self), rate_function({self.state, index}));
  set_rate(self.world, id_of(self), check_number(self.state, index, "emitter", "rate", "1/s"));
}

std::vector<Field> settings() {
  return {
      {"at", "vec|vec[]|Point|Particle", "m",
       "where particles begin: a position, a box { vec, vec }, or a point that carries it", read_place,
       [](const Self& s, int i) { set_position(s.world, id_of(s), check_emitter_position(s.state, i, "emitter")); }},
      {"rate", "number|fun(t: number): number", "1/s", "particles per second; read: of the last step",
       [](const Self& s) { lua_pushnumber(s.state, row(s).rate); }, write_rate},
      {"velocity", "vec", "m/s", "relative to the point that carries it",
       [](const Self& s) { push(s.state, row(s).velocity); },
       [](const Self& s, int i) {
         set_velocity(s.world, id_of(s), check_vec(s.state, i, "emitter", "velocity", "m/s"));
       }},
      {"spread", "number", "rad", "half angle of the cone of velocities",
       [](const Self& s) { lua_pushnumber(s.state, row(s).spread); },
       [](const Self& s, int i) {
         set_spread(s.world, id_of(s), check_number(s.state, i, "emitter", "spread", "rad"));
       }},
      {"lifetime", "number|{ min: number, max: number }", "s", "of its particles, or between which it is random",
       read_lifetime,
       [](const Self& s, int i) {
         const auto [shortest, longest] = check_lifetimes(s.state, i, "emitter");
         set_lifetimes(s.world, id_of(s), shortest, longest);
       }},
      {"max", "number", "1", "particles of it that may live at once",
       [](const Self& s) {
         const std::uint64_t max = row(s).max;
         lua_pushnumber(s.state,
                        max == std::numeric_limits<std::uint64_t>::max() ? infinity : static_cast<double>(max));
       },
       [](const Self& s, int i) { set_max(s.world, id_of(s), check_max(s.state, i, "emitter")); }},
      {"enabled", "boolean", "", "whether it makes particles",
       [](const Self& s) { lua_pushboolean(s.state, row(s).enabled); },
       [](const Self& s, int i) { set_enabled(s.world, id_of(s), check_boolean(s.state, i, "emitter", "enabled")); }},
  };
}

Type make() {
  Type type{"Emitter", "emitter", "Makes particles at a rate.", {}, {}};
  type.fields = settings();
  type.fields.push_back({"family", "Family?", "", "of its particles",
                         [](const Self& s) {
                           const FamilyId family = row(s).family;
                           push_thing(s.state, s.script, family ? AnyId(family) : AnyId());
                         },
                         nullptr});
  type.fields.push_back({"count", "integer", "", "how many of its particles live",
                         [](const Self& s) { lua_pushinteger(s.state, static_cast<lua_Integer>(row(s).count)); },
                         nullptr});
  type.fields.push_back({"made", "integer", "", "how many it has made",
                         [](const Self& s) { lua_pushinteger(s.state, static_cast<lua_Integer>(row(s).made)); },
                         nullptr});
  add_base(type, any_thing_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& emitter_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
