#include "lua/thing/ground_options.hpp"

#include "lua/thing/picture_options.hpp"
#include "lua/thing/shape_options.hpp"
#include "lua/value/values.hpp"

namespace pantin::lua {

Color color_option(const Options& o, const std::shared_ptr<const Cover>& cover, const Color& usual) {
  return o.color("color").value_or(cover ? untinted : usual);
}

std::vector<ShapeValue> shape_options(Script& script, const Options& o, const Color& usual) {
  std::vector<ShapeValue> values;
  const std::string layer = layer_option(o);
  const std::shared_ptr<const Cover> cover = picture_option(script, o);
  const auto add = [&](const ShapeValue& value) {
    values.push_back(value);
    ShapeDef& def = values.back().def;
    if (def.layer.empty()) def.layer = layer;
    if (!def.cover) def.cover = spread(cover, def.geometry);
    def.color = value.color ? *value.color : color_option(o, def.cover, usual);
  };
  lua_State* state = o.state();
  require(!o.has("shape") || !o.has("shapes"), o.what(), ": takes shape, or a list shapes, not both");
  if (o.has("shape")) add(check_shape_value(state, o.push("shape"), o.what(), "shape"));
  if (o.has("shapes")) {
    const int list = o.push("shapes");
    require(lua_istable(state, list), o.what(), ": shapes must be a list of shapes, got ", kind_of_value(state, list));
    for (lua_Unsigned i = 1; i <= lua_rawlen(state, list); i++) {
      lua_rawgeti(state, list, static_cast<lua_Integer>(i));
      add(check_shape_value(state, -1, o.what(), text("shape ", i)));
      lua_pop(state, 1);
    }
    require(!values.empty(), o.what(), ": shapes must be a list of shapes, got none");
  }
  if (!values.empty()) lua_pop(state, 1);
  return values;
}

void refuse_material(lua_State* state, int index, const std::string& what) {
  refuse_options(state, index, what,
                 {"density", "friction", "restitution", "rolling", "spinning", "surface_velocity", "sensor"},
                 "Each of its shapes has one: shape = shape.box { size = 1, friction = 0.8 }");
}

const char* const stands_still =
    "What stands in the world does not move. A belt is { surface_velocity = vec(…) } [m/s] of its shape; what shall "
    "move "
    "is a body that scene:follow and scene:orient take along functions of time";

namespace {

void refuse_motion(lua_State* state, int index, const char* what) {
  refuse_options(state, index, what, {"velocity", "spin"}, stands_still);
}

}  // namespace

ShapeDef floor_def(Script& script, lua_State* state, int index) {
  refuse_motion(state, index, "floor");
  refuse_options(state, index, "floor", {"at"}, "It has no end; height [m] says how far along its normal it lies");
  const ShapeKind& kind = shape_kind("plane");
  const Options o(state, index, "floor",
                  with_names(kind.sizes, {"friction", "restitution", "rolling", "spinning", "surface_velocity", "layer",
                                          "sensor", "size", "color", "picture", "name"}));
  ShapeDef def = shape_of_sizes(script, kind, o).def;
  def.cover = spread(picture_option(script, o), def.geometry);
  def.color = color_option(o, def.cover, def.color);
  def.name = o.string("name").value_or("");
  def.extent = o.number("size", "m");
  require(!def.extent || *def.extent > 0.0, "floor: size must be > 0 m, got ", def.extent.value_or(0.0));
  return def;
}

std::vector<ShapeDef> ground_defs(Script& script, lua_State* state, int index) {
  refuse_motion(state, index, "ground");
  refuse_material(state, index, "ground");
  refuse_options(state, index, "ground", {"name"},
                 "Each of its shapes has one: shape = shape.box { size = 1, name = \"step\" }");
  const Options o(state, index, "ground", {"shape", "shapes", "at", "orientation", "color", "picture", "layer"});
  const ShapeDef usual;
  std::vector<ShapeDef> defs;
  for (ShapeValue& value : shape_options(script, o, usual.color)) defs.push_back(std::move(value.def));
  require(!defs.empty(), "ground: needs a shape, scene:ground { shape = shape.box(10, 1, 10) }");
  const Vec3 at = o.vector("at", "m").value_or(zero3());
  const Quat turn = normalised(o.quat("orientation").value_or(Quat{}));
  for (ShapeDef& def : defs) {
    def.at = at + rotate(turn, def.at);
    def.orientation = normalised(turn * def.orientation);
  }
  return defs;
}

}  // namespace pantin::lua
