#include "edit/edit.hpp"
#include "lua/thing/body_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/picture_fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

BodyId body_id(const Self& self) { return self.ref.id<BodyId>(); }
Body& body_row(const Self& self) { return self.world.bodies[body_id(self)]; }

std::optional<Vec3> place(lua_State* state, const char* call) {
  if (lua_isnoneornil(state, 3)) return {};
  return check_vec(state, 3, call, "at", "m");
}

int push_force(lua_State* state) {
  const Self self = check_self(state, Kind::body, "push");
  push(self.world, body_id(self), check_vec(state, 2, "push", "force", "N"), place(state, "push"));
  return 0;
}

int kick_body(lua_State* state) {
  const Self self = check_self(state, Kind::body, "kick");
  kick(self.world, body_id(self), check_vec(state, 2, "kick", "impulse", "N s"), place(state, "kick"));
  return 0;
}

int twist_body(lua_State* state) {
  const Self self = check_self(state, Kind::body, "twist");
  twist(self.world, body_id(self), check_vec(state, 2, "twist", "torque", "N m"));
  return 0;
}

int add_point_to(lua_State* state) {
  const Self self = check_self(state, Kind::body, "add_point");
  push_thing(state, self.script,
             add_point(self.world, body_id(self), point_def(state, 2, "add_point", "argument 1", true)));
  return 1;
}

int remove_point_of(lua_State* state) {
  const Self self = check_self(state, Kind::body, "remove_point");
  const PointId point = check_kind(state, 2, Kind::point, "remove_point", argument(1)).id<PointId>();
  require(self.world.points[point].body == body_id(self), "remove_point: ", describe(self.world, point),
          " is no point of ", describe(self.ref));
  remove_point(self.world, point);
  return 0;
}

/// Its points by their names.
bool named_point(const Self& self, const char* name) {
  for (PointId p : body_row(self).points)
    if (self.world.points[p].name == name && *name) return push_thing(self.state, self.script, p), true;
  return false;
}

std::vector<std::string> names_of_points(const Self& self) {
  std::vector<std::string> names;
  for (PointId p : body_row(self).points)
    if (const std::string& name = self.world.points[p].name; !name.empty()) names.push_back(name);
  return names;
}

Type make_body_type() {
  Type type = type_with(fields::body_type());
  type.fields.push_back(picture_of_body());
  type.fields.push_back(sprite_of_body());
  type.methods = {
      {"push", guard<push_force>, "force: vec [N], at?: vec [m]", "",
       "Pulls for the coming step, at its centre of mass or at a position of the world.",
       "scene:on(\"step\", function() block:push(vec(0, 20, 0), block.points[1].position) end)"},
      {"kick", guard<kick_body>, "impulse: vec [N s], at?: vec [m]", "",
       "Changes the velocity at once, at its centre of mass or at a position of the world. What ties take of that is "
       "in no force of theirs, and breaks none: a push does.",
       "block:kick(vec(0, 2, 0))"},
      {"twist", guard<twist_body>, "torque: vec [N m]", "", "Turns for the coming step.",
       "scene:on(\"step\", function() block:twist(vec(0, 0, 0.5)) end)"},
      {"add_point", guard<add_point_to>, "point: vec|AddPointOptions [m]", "Point",
       "Adds a point at a position in its frame.",
       "local handle = block:add_point { at = vec(0, 1, 0), mass = 0.2, name = \"handle\" }"},
      {"remove_point", guard<remove_point_of>, "point: Point", "", "Takes a point off.",
       "block:remove_point(block.points[8])"},
  };
  add_base(type, any_thing_type());
  add_common_remove(type);
  type.more = named_point;
  type.more_names = names_of_points;
  type.more_doc = "Point its named points";
  return type;
}

}  // namespace

const Type& body_type() {
  static const Type type = make_body_type();
  return type;
}

}  // namespace pantin::lua
