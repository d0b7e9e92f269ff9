#include "lua/scene/touch_methods.hpp"

#include "edit/edit.hpp"
#include "lua/scene/layers.hpp"
#include "lua/thing/ground_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

int scene_floor(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "floor");
  push_thing(state, self.script, add_shape(self.world, floor_def(self.script, state, 2)));
  return 1;
}

int scene_ground(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "ground");
  const std::vector<ShapeDef> defs = ground_defs(self.script, state, 2);
  luaL_checkstack(state, static_cast<int>(defs.size()) + 8, "ground: too many shapes at once");
  for (const ShapeId shape : add_shapes(self.world, defs)) push_thing(state, self.script, shape);
  return static_cast<int>(defs.size());
}

std::string check_layer(lua_State* state, int index) {
  const std::string name = index == 2 ? "argument 1, a layer," : "argument 2, a layer,";
  const std::string layer = check_text(state, index, "collide", name);
  require(!layer.empty(), "collide: ", name, " must not be empty");
  return layer;
}

int scene_collide(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "collide");
  const std::string a = check_layer(state, 2), b = check_layer(state, 3);
  LayerRule rule;
  if (lua_isboolean(state, 4)) {
    rule.collide = lua_toboolean(state, 4) != 0;
  } else {
    require(lua_istable(state, 4), "collide: argument 3 must be true, false or { friction, restitution }, got ",
            kind_of_value(state, 4));
    const Options o(state, 4, "collide", {"friction", "restitution"});
    rule.friction = o.number("friction", "");
    rule.restitution = o.number("restitution", "");
  }
  set_rule(self.world, a, b, rule);
  for (const std::string& layer : {a, b}) speak_of_layer(self.script, state, "collide", layer);
  return 0;
}

}  // namespace

std::vector<Method> touch_methods() {
  return {
      {"floor", guard<scene_floor>, "options?: FloorOptions", "Collider",
       "Makes a plane on which things rest, solid below.",
       "local floor = scene:floor { height = -9, friction = 0.8 }\n"
       "floor.friction = 0.2"},
      {"ground", guard<scene_ground>, "options: GroundOptions", "Collider",
       "Puts shapes into the world, where they stay: things rest on them and strike them. Returns each of them.",
       "local slab = scene:ground { shape = shape.box(10, 1, 10), at = vec(0, -9, 0), color = \"#987\" }"},
      {"collide", guard<scene_collide>, "a: string, b: string, how: boolean|PairOptions", "",
       "Says how shapes of two layers touch, or two of one layer: not at all, with a friction and restitution of their "
       "own, or as usual (true). What was said before of the two is forgotten.",
       "scene:collide(\"car\", \"ghost\", false)\n"
       "scene:collide(\"ice\", \"rubber\", { friction = 0.05, restitution = 0.3 })"},
  };
}

}  // namespace pantin::lua
