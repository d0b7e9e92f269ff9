// What is met by rays and shapes on their way, and what is where.
#include "lua/scene/layers.hpp"
#include "lua/scene/touch_methods.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "measure/hits.hpp"

namespace pantin::lua {
namespace {

const std::vector<std::string> filter_names = {"layer", "layers", "ignore", "sensors"};

/// The script of the scene, or opened scene, that a method was called on.
Script& script_at(lua_State* state, const char* call) {
  const Ref* ref = to_ref(state, 1);
  require(ref && ref->kind == Kind::scene, "scene: call ", call, " with a colon, scene:", call, "(…)");
  return *ref->script;
}

void add_layer(Script& script, const Options& o, const std::string& name, HitFilter& filter) {
  const auto& names = script.world.layers.names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return speak_of_layer(script, o.state(), o.what(), name);
  filter.layers.push_back(static_cast<std::uint32_t>(found - names.begin()) + 1);
}

void read_layers(const Options& o, Script& script, HitFilter& filter) {
  lua_State* state = o.state();
  require(!o.has("layer") || !o.has("layers"), o.what(), ": takes layer, or a list layers, not both");
  filter.any_layer = !o.has("layer") && !o.has("layers");
  if (const auto layer = o.string("layer")) add_layer(script, o, *layer, filter);
  if (o.has("layers")) {
    const int list = o.push("layers");
    require(lua_istable(state, list), o.what(), ": layers must be a list of strings, got ", kind_of_value(state, list));
    for (lua_Unsigned i = 1; i <= lua_rawlen(state, list); i++) {
      lua_rawgeti(state, list, static_cast<lua_Integer>(i));
      add_layer(script, o, check_text(state, -1, o.what(), text("layer ", i)), filter);
      lua_pop(state, 1);
    }
    lua_pop(state, 1);
  }
  std::sort(filter.layers.begin(), filter.layers.end());
}

void add_ignored(lua_State* state, int index, const std::string& what, const std::string& name, const World& world,
                 HitFilter& filter) {
  const Ref& ref = check_thing(state, index, what, name);
  require(ref.kind == Kind::body || ref.kind == Kind::collider || ref.kind == Kind::group, what, ": ", name,
          " must be a body, a collider, a group or a list of these, got ", kind_of_value(state, index));
  const auto add = [&](const auto& self, const AnyId& thing) -> void {
    const auto* group = std::get_if<GroupId>(&thing);
    if (!group) return filter.ignored.push_back(thing);
    for (const AnyId& member : world.groups[*group].members)
      if (alive(world, member)) self(self, member);
  };
  add(add, ref.thing);
}

HitFilter read_filter(const Options& o, Script& script) {
  const World& world = script.world;
  HitFilter filter;
  lua_State* state = o.state();
  read_layers(o, script, filter);
  filter.sensors = o.boolean("sensors").value_or(false);
  if (!o.has("ignore")) return filter;
  const int ignored = o.push("ignore");
  if (lua_istable(state, ignored)) {
    for (lua_Unsigned i = 1; i <= lua_rawlen(state, ignored); i++) {
      lua_rawgeti(state, ignored, static_cast<lua_Integer>(i));
      add_ignored(state, lua_gettop(state), o.what(), text("ignore ", i), world, filter);
      lua_pop(state, 1);
    }
  } else {
    add_ignored(state, ignored, o.what(), "ignore", world, filter);
  }
  lua_pop(state, 1);
  return filter;
}

int push_hits(lua_State* state, Script& script, const std::vector<Hit>& hits, bool with_distance = true) {
  lua_createtable(state, static_cast<int>(hits.size()), 0);
  lua_Integer i = 0;
  for (const Hit& hit : hits) {
    lua_createtable(state, 0, 5);
    if (const BodyId body = script.world.shapes[hit.shape].body) {
      push_thing(state, script, body);
      lua_setfield(state, -2, "body");
    }
    push_thing(state, script, hit.shape);
    lua_setfield(state, -2, "shape");
    push(state, hit.at);
    lua_setfield(state, -2, "at");
    if (norm2(hit.normal) > 0.0) {
      push(state, hit.normal);
      lua_setfield(state, -2, "normal");
    }
    if (with_distance) {
      lua_pushnumber(state, hit.distance);
      lua_setfield(state, -2, "distance");
    }
    lua_rawseti(state, -2, ++i);
  }
  return 1;
}

int scene_ray(lua_State* state) {
  Script& script = script_at(state, "ray");
  require(lua_istable(state, 2), "ray: needs a table, scene:ray { from = vec(0, 1, 0), direction = vec(0, -1, 0) }");
  std::vector<std::string> known = {"from", "to", "direction"};
  known.insert(known.end(), filter_names.begin(), filter_names.end());
  const Options o(state, 2, "ray", known);
  const auto from = o.vector("from", "m"), to = o.vector("to", "m"), direction = o.vector("direction", "");
  require(from.has_value(), "ray: needs from, a vec [m]");
  require(to.has_value() != direction.has_value(), "ray: needs to, a vec [m], or direction, a vec, and not both");
  const HitFilter filter = read_filter(o, script);
  return push_hits(state, script,
                   to ? hits_of_ray(script.world, *from, *to, filter)
                      : hits_of_endless_ray(script.world, *from, *direction, filter));
}

/// A convex shape, put at a position of the world.
struct Tried {
  Geometry geometry;
  Pose pose;
};

Tried check_tried(lua_State* state, const char* call, int at, const char* name) {
  const ShapeDef& def = check_shape_value(state, 2, call, "argument 1, the shape,").def;
  require(is_convex(def.geometry), call, ": argument 1, the shape, must be convex: no plane, mesh or heights");
  return {def.geometry, {check_vec(state, at, call, name, "m") + def.at, matrix(def.orientation)}};
}

int scene_cast(lua_State* state) {
  Script& script = script_at(state, "cast");
  const Tried tried = check_tried(state, "cast", 3, "argument 2, the start,");
  const Vec3 from = check_vec(state, 3, "cast", "argument 2, the start,", "m"),
             to = check_vec(state, 4, "cast", "argument 3, the end,", "m");
  const HitFilter filter = read_filter(Options(state, 5, "cast", filter_names), script);
  return push_hits(state, script, hits_of_cast(script.world, tried.geometry, tried.pose, to - from, filter));
}

int scene_overlap(lua_State* state) {
  Script& script = script_at(state, "overlap");
  const Tried tried = check_tried(state, "overlap", 3, "argument 2, the position,");
  const HitFilter filter = read_filter(Options(state, 4, "overlap", filter_names), script);
  return push_hits(state, script, overlapping(script.world, tried.geometry, tried.pose, filter));
}

int scene_inside(lua_State* state) {
  Script& script = script_at(state, "inside");
  const Vec3 at = check_vec(state, 2, "inside", "argument 1, the position,", "m");
  const HitFilter filter = read_filter(Options(state, 3, "inside", filter_names), script);
  return push_hits(state, script, containing(script.world, at, filter), false);
}

}  // namespace

std::vector<Method> hit_methods() {
  return {
      {"ray", guard<scene_ray>, "options: RayOptions", "Hit[]",
       "Where a ray first meets each shape, nearest first. One that begins in a shape meets it at once.",
       "local hits = scene:ray { from = p.position, direction = vec(0, -1, 0) }\n"
       "if hits[1] then print(hits[1].distance, hits[1].body) end"},
      {"cast", guard<scene_cast>, "shape: Shape, from: vec [m], to: vec [m], filter?: HitFilter", "Hit[]",
       "Where a convex shape that moves straight, without turning, first touches each other, nearest first.",
       "local hits = scene:cast(shape.ball(0.3), p.position, p.position + vec(0, -5, 0), { ignore = block })"},
      {"overlap", guard<scene_overlap>, "shape: Shape, at: vec [m], filter?: HitFilter", "Hit[]",
       "What overlaps a convex shape at a position, the deepest first.",
       "if #scene:overlap(shape.box(1, 1, 1), vec(0, 3, 0)) == 0 then scene:box { size = 1, at = vec(0, 3, 0) } end"},
      {"inside", guard<scene_inside>, "at: vec [m], filter?: HitFilter", "Hit[]",
       "What a position is inside of, the oldest first. A mesh has no inside.",
       "for _, hit in ipairs(scene:inside(p.position)) do print(hit.body) end"},
  };
}

}  // namespace pantin::lua
