#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/pushes.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

PointId id_of(const Self& self) { return self.ref.id<PointId>(); }
Point& row(const Self& self) { return self.world.points[id_of(self)]; }

Type make() {
  Type type{"Point", "point", "A point mass. It belongs to at most one body, and always to one particle.", {}, {}};
  type.fields = {
      {"position", "vec", "m", "position in the world; written only where the point is free",
       [](const Self& s) { push(s.state, position(s.world, id_of(s))); },
       [](const Self& s, int i) { set_position(s.world, id_of(s), check_vec(s.state, i, "point", "position", "m")); }},
      {"velocity", "vec", "m/s", "velocity in the world; written only where the point is free",
       [](const Self& s) { push(s.state, velocity(s.world, id_of(s))); },
       [](const Self& s, int i) {
         set_velocity(s.world, id_of(s), check_vec(s.state, i, "point", "velocity", "m/s"));
       }},
      {"mass", "number", "kg", "mass; 0 only in a body, as an anchor",
       [](const Self& s) { lua_pushnumber(s.state, row(s).mass); },
       [](const Self& s, int i) { set_mass(s.world, id_of(s), check_number(s.state, i, "point", "mass", "kg")); }},
      {"color", "color", "", "of the point", [](const Self& s) { push(s.state, row(s).color); },
       [](const Self& s, int i) { row(s).color = check_color(s.state, i, "point", "color"); }},
      {"radius", "number", "m", "drawn size; 0: the window chooses",
       [](const Self& s) { lua_pushnumber(s.state, row(s).radius); },
       [](const Self& s, int i) {
         const double radius = check_number(s.state, i, "point", "radius", "m");
         require(radius >= 0, "point: radius must be >= 0 m, got ", radius);
         row(s).radius = radius;
       }},
      {"body", "Body?", "", "the body it belongs to, or nil",
       [](const Self& s) {
         if (row(s).body)
           push_thing(s.state, s.script, row(s).body);
         else
           lua_pushnil(s.state);
       },
       nullptr},
      {"particle", "Particle", "", "the particle it is in now: its own, or a hinge",
       [](const Self& s) { push_thing(s.state, s.script, row(s).particle); }, nullptr},
  };
  type.methods = pushes<Kind::point>();
  add_base(type, any_thing_type());
  add_common_remove(type);
  return type;
}

}  // namespace

const Type& point_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
