#include "edit/edit.hpp"
#include "forces/curves.hpp"
#include "lua/law/curve_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/pushes.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

ParticleId particle_id(const Self& self) { return self.ref.id<ParticleId>(); }
Particle& particle_row(const Self& self) { return self.world.particles[particle_id(self)]; }
/// What it answers for: itself, or the hinge it sleeps in.
Particle& ring(const Self& self) { return self.world.particles[awake(self.world, particle_id(self))]; }

int cut_hinge(lua_State* state) {
  const Self self = check_self(state, Kind::particle, "cut");
  require(particle_row(self).is_hinge(), "cut: ", describe(self.ref), " is no hinge");
  if (lua_isnoneornil(state, 2))
    cut(self.world, particle_id(self));
  else
    cut(self.world, particle_id(self), check_body(state, 2, "cut", argument(1)));
  return 0;
}

int force_of_hinge(lua_State* state) {
  const Self self = check_self(state, Kind::particle, "force");
  require(particle_row(self).is_hinge(), "force: ", describe(self.ref), " is no hinge");
  push(state, hinge_force(self.world, particle_id(self), check_body(state, 2, "force", argument(1))));
  return 1;
}

/// Attributes of its family, by name.
bool read_attribute(const Self& self, const char* name) {
  const Particle& particle = ring(self);
  if (!particle.family) return false;
  const std::ptrdiff_t found = self.world.families[particle.family].find(name);
  if (found < 0) return false;
  const auto followed = curve_value(self.world, awake(self.world, particle_id(self)), name, self.world.time);
  lua_pushnumber(self.state, followed.value_or(particle.values[static_cast<std::size_t>(found)]));
  return true;
}

bool write_attribute(const Self& self, const char* name, int index) {
  const Particle& particle = ring(self);
  if (!particle.family || self.world.families[particle.family].find(name) < 0) return false;
  if (lua_isfunction(self.state, index))
    set_curve(self.world, particle_id(self), curve_of(self.state, index, "particle", name));
  else
    set_attribute(self.world, particle_id(self), name, check_number(self.state, index, "particle", name, ""));
  return true;
}

Type make_particle_type() {
  Type type = type_with(fields::particle_type());
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
  static const Type type = make_particle_type();
  return type;
}

}  // namespace pantin::lua
