#include "lua/thing/body_options.hpp"

#include <algorithm>

#include "lua/thing/family_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/ground_options.hpp"
#include "lua/thing/picture_options.hpp"
#include "lua/thing/shape_options.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/values.hpp"

namespace pantin::lua {
namespace {

const char* const inertia_parts[] = {"xx", "yy", "zz", "xy", "xz", "yz"};

void check_point_name(const std::string& call, const std::string& name) {
  require(!name.empty(), call, ": a point's name must not be empty");
  require(!has_member(body_type(), name), call, ": a point cannot have the name '", name,
          "', which a body has already as a field or method");
}

/// List first, then names in sorted order.
std::vector<PointDef> point_defs(lua_State* state, int table) {
  require(lua_istable(state, table), "body: points must be a table of vecs or tables, got ",
          kind_of_value(state, table));
  std::vector<PointDef> points;
  const KeysOfTable keys = keys_of(state, table);
  require(!keys.has_others, "body: points must be a list without gaps, or have names");
  for (lua_Integer i = 1; i <= keys.count; i++) {
    lua_rawgeti(state, table, i);
    points.push_back(point_def(state, lua_gettop(state), "body", text("point ", i), false));
    lua_pop(state, 1);
  }
  for (const std::string& name : keys.names) {
    check_point_name("body", name);
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, table);
    points.push_back(point_def(state, lua_gettop(state), "body", text("point '", name, "'"), false));
    points.back().name = name;
    lua_pop(state, 1);
  }
  return points;
}

}  // namespace

PointDef point_def(lua_State* state, int index, const std::string& call, const std::string& name, bool may_name) {
  PointDef def;
  if (to_vec(state, index)) {
    def.at = check_vec(state, index, call, name, "m");
    return def;
  }
  require(lua_istable(state, index), call, ": ", name,
          " must be a vec [m] or a table { at, mass, color, radius, family }, got ", kind_of_value(state, index));
  const std::string what = text(call, ": ", name);
  std::vector<std::string_view> known = {"at", "mass", "color", "radius"};
  if (may_name) known.push_back("name");
  const FamilyOption family = family_option(state, index, what, known);
  const Options o(state, index, what, known);
  def.at = o.vector("at", "m").value_or(def.at);
  def.mass = o.number("mass", "kg").value_or(def.mass);
  def.radius = o.number("radius", "m").value_or(def.radius);
  def.color = o.color("color");
  def.family = family.id;
  def.attributes = attribute_options(o, family.attributes);
  if (may_name && o.has("name")) {
    def.name = *o.string("name");
    check_point_name(what, def.name);
  }
  return def;
}

namespace {

/// What bodies of all sorts are given.
const std::vector<std::string>& body_options() {
  static const std::vector<std::string> names = {"points",  "at",    "orientation", "velocity", "spin", "mass",
                                                 "inertia", "color", "picture",     "sprite",   "name"};
  return names;
}

BodyDef body_of(Script& script, const Options& o) {
  BodyDef def;
  def.name = o.string("name").value_or("");
  def.mass = o.number("mass", "kg").value_or(0.0);
  require(!o.has("mass") || def.mass > 0, o.what(), ": mass must be > 0 kg, got ", def.mass);
  if (o.has("inertia")) {
    def.inertia = check_inertia(o.state(), o.push("inertia"), o.what());
    lua_pop(o.state(), 1);
  }
  def.at = o.vector("at", "m").value_or(def.at);
  def.orientation = o.quat("orientation").value_or(def.orientation);
  def.velocity = o.vector("velocity", "m/s").value_or(def.velocity);
  def.spin = o.vector("spin", "rad/s").value_or(def.spin);
  def.color = o.color("color").value_or(def.color);
  def.sprite = sprite_option(script, o);
  if (o.has("points")) {
    def.points = point_defs(o.state(), o.push("points"));
    lua_pop(o.state(), 1);
  }
  return def;
}

/// Bodies move; other programs call what does not a body, too.
void refuse_fixed(lua_State* state, int index, const char* what) {
  refuse_options(
      state, index, what, {"fixed", "static", "kinematic"},
      "What does not move is scene:ground { shape = … } or scene:floor {}; what moves along a function of time is "
      "a body that scene:follow and scene:orient take along");
}

/// Fails where a density is given that a mass leaves without effect.
void check_density(const Options& o, const BodyDef& def, const std::vector<ShapeValue>& shapes) {
  const auto given = std::find_if(shapes.begin(), shapes.end(), [](const ShapeValue& s) { return s.density_given; });
  if (given == shapes.end()) return;
  const auto filled = std::count_if(shapes.begin(), shapes.end(), [](const ShapeValue& s) { return !s.def.sensor; });
  require(def.mass == 0.0 || filled > 1, o.what(), ": takes mass or density, not both: with a mass of ", def.mass,
          " kg the density of ", given->def.material.density, " kg/m³ has no effect; leave one out");
}

}  // namespace

BodyDef body_def(Script& script, lua_State* state, int index) {
  refuse_fixed(state, index, "body");
  refuse_material(state, index, "body");
  static const std::vector<std::string> known = with_names(body_options(), {"shape", "shapes", "layer"});
  const Options o(state, index, "body", known);
  require(lua_istable(state, index), "body: needs a table, scene:body{ points = { … }, mass = 1 }");
  BodyDef def = body_of(script, o);
  std::vector<ShapeValue> shapes = shape_options(script, o, def.color);
  check_density(o, def, shapes);
  for (ShapeValue& shape : shapes) def.shapes.push_back(std::move(shape.def));
  require(!def.shapes.empty() || !o.has("layer"), "body: layer is of its shapes, and it has none");
  require(!def.shapes.empty() || !o.has("picture"), "body: picture is of its shapes, and it has none");
  for (std::size_t i = 0; i < def.shapes.size(); i++)
    require(is_convex(def.shapes[i].geometry), "body: shape ", i + 1,
            " is a plane, a mesh or heights, which do not move; give it to scene:ground");
  return def;
}

BodyDef solid_def(Script& script, lua_State* state, int index, const char* name, const char* call) {
  const ShapeKind& kind = shape_kind(name);
  refuse_fixed(state, index, call);
  const Options o(state, index, call, with_names(with_names(kind.sizes, material_options()), body_options()));
  BodyDef def = body_of(script, o);
  const ShapeValue shape = shape_of_sizes(script, kind, o);
  check_density(o, def, {shape});
  def.shapes = {shape.def};
  def.shapes[0].cover = spread(picture_option(script, o), shape.def.geometry);
  def.shapes[0].color = color_option(o, def.shapes[0].cover, def.color);
  return def;
}

Mat3 check_inertia(lua_State* state, int index, const std::string& what) {
  if (to_vec(state, index)) return diagonal(check_vec(state, index, what, "inertia", "kg m²"));
  require(lua_istable(state, index), what,
          ": inertia must be a vec of the diagonal or a table { xx, yy, zz, xy, xz, yz } [kg m²], got ",
          kind_of_value(state, index));
  double v[6] = {};
  if (lua_rawlen(state, index) > 0) {
    require(lua_rawlen(state, index) == 6, what,
            ": inertia must have six numbers, xx, yy, zz, xy, xz, yz [kg m²], got ", lua_rawlen(state, index));
    for (int i = 0; i < 6; i++) {
      lua_rawgeti(state, index, i + 1);
      v[i] = check_number(state, -1, what, text("inertia's ", inertia_parts[i]), "kg m²");
      lua_pop(state, 1);
    }
  } else {
    const Options o(state, index, what + ": inertia", {"xx", "yy", "zz", "xy", "xz", "yz"});
    for (int i = 0; i < 6; i++) v[i] = o.number(inertia_parts[i], "kg m²").value_or(0.0);
  }
  return {{vec(v[0], v[3], v[4]), vec(v[3], v[1], v[5]), vec(v[4], v[5], v[2])}};
}

void push_inertia(lua_State* state, const Mat3& m) {
  if (const auto moments = fields::diagonal_of(m)) return pantin::lua::push(state, *moments);
  const double v[] = {m[0][0], m[1][1], m[2][2], m[1][0], m[2][0], m[2][1]};
  lua_createtable(state, 0, 6);
  for (int i = 0; i < 6; i++) {
    lua_pushnumber(state, v[i]);
    lua_setfield(state, -2, inertia_parts[i]);
  }
}

}  // namespace pantin::lua
