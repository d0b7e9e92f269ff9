#include "edit/edit.hpp"
#include "forces/curves.hpp"
#include "lua/law/curve_options.hpp"
#include "lua/thing/constraint_fields.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/look_options.hpp"
#include "lua/thing/pushes.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

ParticleId id_of(const Self& self) { return self.ref.id<ParticleId>(); }
Particle& row(const Self& self) { return self.world.particles[id_of(self)]; }
/// What it answers for: itself, or the hinge it sleeps in.
Particle& ring(const Self& self) { return self.world.particles[awake(self.world, id_of(self))]; }

/// The point of a particle of one point, which is not in a hinge.
PointId only_point(const Self& self, const char* field) {
  require(!ring(self).is_hinge(), "particle: ", field,
          " of a hinge belongs to its points; change theirs or their bodies'");
  return row(self).points[0];
}

int cut_hinge(lua_State* state) {
  const Self self = check_self(state, Kind::particle, "cut");
  require(row(self).is_hinge(), "cut: ", describe(self.ref), " is no hinge");
  if (lua_isnoneornil(state, 2))
    cut(self.world, id_of(self));
  else
    cut(self.world, id_of(self), check_body(state, 2, "cut", argument(1)));
  return 0;
}

int force_of_hinge(lua_State* state) {
  const Self self = check_self(state, Kind::particle, "force");
  require(row(self).is_hinge(), "force: ", describe(self.ref), " is no hinge");
  push(state, hinge_force(self.world, id_of(self), check_body(state, 2, "force", argument(1))));
  return 1;
}

void read_bodies(const Self& self) {
  std::vector<BodyId> bodies;
  for (PointId p : ring(self).points)
    if (const BodyId body = self.world.points[p].body) bodies.push_back(body);
  push_list(self.state, self.script, bodies);
}

/// Makes a field follow the function of (age, life) at `index`, or returns false where there is none.
bool write_curve(const Self& self, const char* name, int index) {
  if (!lua_isfunction(self.state, index)) return false;
  set_curve(self.world, id_of(self), curve_of(self.state, index, "particle", name));
  return true;
}

/// Attributes of its family, by name.
bool read_attribute(const Self& self, const char* name) {
  const Particle& particle = ring(self);
  if (!particle.family) return false;
  const std::ptrdiff_t found = self.world.families[particle.family].find(name);
  if (found < 0) return false;
  const auto followed = curve_value(self.world, awake(self.world, id_of(self)), name, self.world.time);
  lua_pushnumber(self.state, followed.value_or(particle.values[static_cast<std::size_t>(found)]));
  return true;
}

bool write_attribute(const Self& self, const char* name, int index) {
  const Particle& particle = ring(self);
  if (!particle.family || self.world.families[particle.family].find(name) < 0) return false;
  if (write_curve(self, name, index)) return true;
  set_attribute(self.world, id_of(self), name, check_number(self.state, index, "particle", name, ""));
  return true;
}

std::vector<Field> look_and_life() {
  return {
      {"family", "Family?", "", "its family, whose attributes are fields of it: p.charge",
       [](const Self& s) { push_thing(s.state, s.script, ring(s).family ? AnyId(ring(s).family) : AnyId()); },
       [](const Self& s, int i) {
         FamilyId family;
         if (!lua_isnil(s.state, i)) family = check_kind(s.state, i, Kind::family, "particle", "family").id<FamilyId>();
         set_family(s.world, id_of(s), family);
       }},
      {"lifetime", "number", "s",
       "goes at the beginning of the first step at which its age has reached this; a hinge is cut; math.huge: never",
       [](const Self& s) { lua_pushnumber(s.state, ring(s).lifetime); },
       [](const Self& s, int i) {
         const double life = check_number_or_infinity(s.state, i, "particle", "lifetime", "s");
         set_lifetime(s.world, awake(s.world, id_of(s)), life);
       }},
      {"age", "number", "s", "time since it was made",
       [](const Self& s) { lua_pushnumber(s.state, s.world.time - ring(s).born); }, nullptr},
      {"color", "color|fun(age: number, life: number): color", "",
       "or a function of age and lifetime [s]; overrides its points'",
       [](const Self& s) { push(s.state, present_color(s.world, awake(s.world, id_of(s)))); },
       [](const Self& s, int i) {
         if (write_curve(s, "color", i)) return;
         set_color(s.world, awake(s.world, id_of(s)), check_color(s.state, i, "particle", "color"));
       }},
      {"radius", "number|fun(age: number, life: number): number", "m",
       "or a function of age and lifetime [s]; overrides its points'",
       [](const Self& s) { lua_pushnumber(s.state, present_radius(s.world, awake(s.world, id_of(s)))); },
       [](const Self& s, int i) {
         if (write_curve(s, "radius", i)) return;
         const double radius = check_number(s.state, i, "particle", "radius", "m");
         set_radius(s.world, awake(s.world, id_of(s)), radius);
       }},
      {"look", "Look", "",
       "\"ball\", \"glow\" (a soft disc of light) or \"streak\" (a line of light along its velocity)",
       [](const Self& s) { lua_pushstring(s.state, name_of(look_of(s.world, ring(s)))); },
       [](const Self& s, int i) { set_look(s.world, awake(s.world, id_of(s)), check_look(s.state, i, "particle")); }},
      {"points", "Point[]", "", "its points, in the order of joining",
       [](const Self& s) { push_list(s.state, s.script, ring(s).points); }, nullptr},
      {"bodies", "Body[]", "", "the bodies of its points", read_bodies, nullptr},
      {"enabled", "boolean", "", "of a hinge: whether its points stay together (default `true`)",
       [](const Self& s) { lua_pushboolean(s.state, ring(s).enabled); },
       [](const Self& s, int i) {
         set_enabled(s.world, awake(s.world, id_of(s)), check_boolean(s.state, i, "hinge", "enabled"));
       }},
      {"breaks_at", "Breaking", "", "of a hinge: load at which it breaks (default `{}`)",
       [](const Self& s) { push_breaking(s.state, ring(s).breaks_at); },
       [](const Self& s, int i) {
         set_breaks_at(s.world, awake(s.world, id_of(s)), check_breaking(s.state, i, "hinge: breaks_at", false));
       }},
      {"is_hinge", "boolean", "", "whether it joins two points or more",
       [](const Self& s) { lua_pushboolean(s.state, ring(s).is_hinge()); }, nullptr},
  };
}

Type make() {
  Type type{"Particle",
            "particle",
            "A ring of one or more points. One point: an ordinary particle. More: a hinge, whose points coincide.",
            {},
            {}};
  type.fields = {
      {"position", "vec", "m", "position in the world; written only of a free particle",
       [](const Self& s) { push(s.state, position(s.world, id_of(s))); },
       [](const Self& s, int i) {
         set_position(s.world, only_point(s, "position"), check_vec(s.state, i, "particle", "position", "m"));
       }},
      {"velocity", "vec", "m/s", "velocity in the world; written only of a free particle",
       [](const Self& s) { push(s.state, velocity(s.world, id_of(s))); },
       [](const Self& s, int i) {
         set_velocity(s.world, only_point(s, "velocity"), check_vec(s.state, i, "particle", "velocity", "m/s"));
       }},
      {"mass", "number", "kg", "mass; of a hinge its points' sum, which is not written",
       [](const Self& s) { lua_pushnumber(s.state, mass(s.world, awake(s.world, id_of(s)))); },
       [](const Self& s, int i) {
         set_mass(s.world, only_point(s, "mass"), check_number(s.state, i, "particle", "mass", "kg"));
       }},
  };
  for (Field& field : look_and_life()) type.fields.push_back(field);
  type.methods = pushes<Kind::particle>();
  type.methods.push_back({"cut", guard<cut_hinge>, "body?: Body", "",
                          "Frees all members of a hinge, or those of one body.", "elbow:cut()"});
  type.methods.push_back({"force", guard<force_of_hinge>, "body: Body", "vec",
                          "Force [N] of a hinge on one of its bodies in the last step.",
                          "scene:probe(\"pull\", function() return elbow:force(arm):length() end)"});
  add_base(type, any_thing_type());
  add_common_remove(type);
  type.more = read_attribute;
  type.write_more = write_attribute;
  type.more_doc = "number [each its own] attributes of its family";
  return type;
}

}  // namespace

const Type& particle_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
