#include "lua/thing/shape_type.hpp"

#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"
#include "shapes/mass.hpp"

namespace pantin::lua {
namespace {

/// Lua aligns less than vectors need, so the value is elsewhere.
struct ShapeRef : Ref {
  std::shared_ptr<const ShapeValue> value;
};

int drop_shape(lua_State* state) {
  static_cast<ShapeRef*>(lua_touserdata(state, 1))->value.reset();
  return 0;
}

const ShapeValue& shape_of(const Self& self) { return *static_cast<const ShapeRef&>(self.ref).value; }

/// Pushes what a shape with a volume has of it, else nil.
template <class Read>
void push_solid(const Self& self, const Read& read) {
  const ShapeDef& def = shape_of(self).def;
  if (!is_convex(def.geometry)) return lua_pushnil(self.state);
  read(def, solid_mass(def.geometry));
}

void read_volume(const Self& self) {
  push_solid(self, [&](const ShapeDef&, const SolidMass& solid) { lua_pushnumber(self.state, solid.volume); });
}

void read_mass(const Self& self) {
  push_solid(self, [&](const ShapeDef& def, const SolidMass& solid) {
    lua_pushnumber(self.state, solid.volume * def.material.density);
  });
}

void read_centre(const Self& self) {
  push_solid(self, [&](const ShapeDef& def, const SolidMass& solid) {
    push(self.state, def.at + rotate(def.orientation, solid.centre));
  });
}

int move_shape(lua_State* state) {
  const Self self = check_self(state, Kind::shape, "move");
  ShapeValue value = shape_of(self);
  value.def.at += check_vec(state, 2, "move", "argument 1", "m");
  push_shape(state, self.script, std::move(value));
  return 1;
}

int rotate_shape(lua_State* state) {
  const Self self = check_self(state, Kind::shape, "rotate");
  const Quat turn = check_quat(state, 2, "rotate", "argument 1");
  ShapeValue value = shape_of(self);
  value.def.at = rotate(turn, value.def.at);
  value.def.orientation = normalised(turn * value.def.orientation);
  push_shape(state, self.script, std::move(value));
  return 1;
}

Type make_shape_type() {
  Type type{"Shape", "shape", "What touches, and what it is made of: a value, which does not change.", {}, {}};
  type.fields = {
      {"kind", "string", "", "\"ball\", \"box\", \"capsule\" …, as it was made",
       [](const Self& s) { lua_pushstring(s.state, shape_of(s).kind); }, nullptr},
      {"volume", "number?", "m³", "inside it; nil of a plane, a mesh and heights", read_volume, nullptr},
      {"mass", "number?", "kg", "of its volume filled with its density; nil without a volume", read_mass, nullptr},
      {"centre", "vec?", "m", "its centre of mass in the frame of its body; nil without a volume", read_centre,
       nullptr},
      {"density", "number", "kg/m³", "of a body whose mass is not given",
       [](const Self& s) { lua_pushnumber(s.state, shape_of(s).def.material.density); }, nullptr},
      {"friction", "number", "1", "of two that touch the root of the product counts",
       [](const Self& s) { lua_pushnumber(s.state, shape_of(s).def.material.friction); }, nullptr},
      {"restitution", "number", "1", "0 to 1; of two that touch the larger counts",
       [](const Self& s) { lua_pushnumber(s.state, shape_of(s).def.material.restitution); }, nullptr},
      {"rolling", "number", "m", "moment by normal force against rolling; of two that touch the larger counts",
       [](const Self& s) { lua_pushnumber(s.state, shape_of(s).def.material.rolling); }, nullptr},
      {"spinning", "number", "m",
       "moment by normal force against spinning on the spot; of two that touch the larger counts",
       [](const Self& s) { lua_pushnumber(s.state, shape_of(s).def.material.spinning); }, nullptr},
      {"layer", "string?", "", "that scene:collide speaks of; nil: that of its body, or none",
       [](const Self& s) {
         const std::string& layer = shape_of(s).def.layer;
         layer.empty() ? lua_pushnil(s.state) : static_cast<void>(lua_pushlstring(s.state, layer.data(), layer.size()));
       },
       nullptr},
      {"sensor", "boolean", "", "tells what it touches, and pushes nothing",
       [](const Self& s) { lua_pushboolean(s.state, shape_of(s).def.sensor); }, nullptr},
      {"surface_velocity", "vec", "m/s",
       "of its surface against its body, as of a belt; along the axes of the body, with which it turns, or of the "
       "world for what stands in it",
       [](const Self& s) { push(s.state, shape_of(s).def.material.surface_velocity); }, nullptr},
  };
  type.methods = {
      {"move", guard<move_shape>, "by: vec [m]", "Shape", "Moved in the frame of its body.",
       "local head = shape.box(1, 1, 1):move(vec(0, 2, 0))"},
      {"rotate", guard<rotate_shape>, "turn: quat", "Shape", "Turned about the origin of its body's frame.",
       "local log = shape.cylinder(0.2, 3):rotate(quat(vec(0, 0, 1), math.pi / 2))"},
  };
  return type;
}

}  // namespace

void push_shape(lua_State* state, Script& script, ShapeValue value) {
  auto kept = std::make_shared<const ShapeValue>(std::move(value));
  const Ref ref = make_ref(script, Kind::shape, 1, 1, 0);
  new (lua_newuserdatauv(state, sizeof(ShapeRef), 0)) ShapeRef{ref, std::move(kept)};
  push_metatable(state, Kind::shape);
  lua_pushcfunction(state, drop_shape);
  lua_setfield(state, -2, "__gc");
  lua_setmetatable(state, -2);
}

const ShapeValue& check_shape_value(lua_State* state, int index, std::string_view what, std::string_view name) {
  const Ref* ref = to_ref(state, index);
  require(ref && ref->kind == Kind::shape, what, ": ", name, " must be a shape, as shape.box(1, 1, 1), got ",
          kind_of_value(state, index));
  return *static_cast<const ShapeRef*>(ref)->value;
}

const Type& shape_type() {
  static const Type type = make_shape_type();
  return type;
}

}  // namespace pantin::lua
