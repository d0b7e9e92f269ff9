// The table `shape`: what touches.
#include "lua/thing/script.hpp"
#include "lua/thing/shape_options.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// A number, a vec, a structure or a list, and no table of options.
bool is_by_position(lua_State* state, int index) {
  const int type = lua_type(state, index);
  return type == LUA_TNUMBER || type == LUA_TUSERDATA || (type == LUA_TTABLE && lua_rawlen(state, index) > 0);
}

std::vector<const char*> names_by_position(lua_State* state, const ShapeKind& kind) {
  // A box of one length is a cube, of a vec that large.
  if (std::string_view(kind.name) == "box" && lua_type(state, 2) != LUA_TNUMBER) return {"size"};
  return kind.by_position;
}

/// Puts what was given by position into a table of options at 1, with those of a table after it.
void name_arguments(lua_State* state, const ShapeKind& kind) {
  const std::vector<const char*> names = names_by_position(state, kind);
  int given = 0;
  while (given < static_cast<int>(names.size()) && is_by_position(state, given + 1)) given++;
  const int last = lua_gettop(state), table = last + 1;
  require(last <= given + 1, kind.name, ": takes ",
          given == 0 ? "a table of options" : "at most a table after its sizes", ", got ", last, " values");
  if (given == 0) return;
  lua_newtable(state);
  if (last > given && !lua_isnil(state, last)) {
    require(lua_istable(state, last), kind.name, ": the options must be a table { name = value }, got ",
            kind_of_value(state, last));
    lua_pushnil(state);
    while (lua_next(state, last)) {
      lua_pushvalue(state, -2);
      lua_insert(state, -2);
      lua_rawset(state, table);
    }
  }
  for (int i = 0; i < given; i++) {
    const char* name = names[static_cast<std::size_t>(i)];
    require(lua_getfield(state, table, name) == LUA_TNIL, kind.name, ": its ", name, " is given twice");
    lua_pop(state, 1);
    lua_pushvalue(state, i + 1);
    lua_setfield(state, table, name);
  }
  lua_replace(state, 1);
  lua_settop(state, 1);
}

int make(lua_State* state, const char* name) {
  const ShapeKind& kind = shape_kind(name);
  name_arguments(state, kind);
  push_shape(state, script_of(state), shape_at(script_of(state), kind, state, 1));
  return 1;
}

int ball(lua_State* state) { return make(state, "ball"); }
int box(lua_State* state) { return make(state, "box"); }
int capsule(lua_State* state) { return make(state, "capsule"); }
int cylinder(lua_State* state) { return make(state, "cylinder"); }
int hull(lua_State* state) { return make(state, "hull"); }
int polygon(lua_State* state) { return make(state, "polygon"); }
int line(lua_State* state) { return make(state, "line"); }
int plane(lua_State* state) { return make(state, "plane"); }
int mesh(lua_State* state) { return make(state, "mesh"); }
int heights(lua_State* state) { return make(state, "heights"); }

int unknown_shape(lua_State* state) {
  std::vector<std::string> names;
  for (const Method& maker : shape_makers()) names.push_back(maker.name);
  const std::string name(push_text(state, 2));
  throw Error(text("shape: unknown shape '", name, "'.", suggestion(name, names), " Known are ", joined(names)));
}

std::vector<Method> make_all() {
  return {
      {"ball", guard<ball>, "radius: number|BallShapeOptions [m], options?: BallShapeOptions", "Shape", "A ball.",
       "local ball = shape.ball { radius = 0.5, restitution = 0.8 }\n"
       "local rubber = shape.ball(0.5, { restitution = 0.8 })"},
      {"box", guard<box>,
       "x: number|vec|BoxShapeOptions [m], y?: number|BoxShapeOptions [m], z?: number [m], options?: BoxShapeOptions",
       "Shape", "A box along the axes; of one length a cube.",
       "local brick = shape.box { size = vec(0.24, 0.07, 0.12), density = 1900 }\n"
       "local plank = shape.box(2, 0.05, 0.3)"},
      {"capsule", guard<capsule>,
       "radius: number|CapsuleShapeOptions [m], length?: number [m], options?: CapsuleShapeOptions", "Shape",
       "All within a radius of a line: a cylinder with round ends.",
       "local limb = shape.capsule { radius = 0.1, from = vec(0, 0, 0), to = vec(1, 0, 0) }\n"
       "local post = shape.capsule(0.1, 1)"},
      {"cylinder", guard<cylinder>,
       "radius: number|CylinderShapeOptions [m], length?: number [m], options?: CylinderShapeOptions", "Shape",
       "A cylinder along y, or along an axis.",
       "local wheel = shape.cylinder { radius = 0.4, length = 0.1, axis = vec(0, 0, 1) }"},
      {"hull", guard<hull>, "points: vec[]|Structure|HullShapeOptions [m], options?: HullShapeOptions", "Shape",
       "The convex hull of at most 100,000 points, or of the vertices of a structure; it may have 10,000 corners.",
       "local die = shape.hull(structure.dodecahedron { edge = 0.2 }, { friction = 0.3 })"},
      {"polygon", guard<polygon>,
       "points: vec[]|PolygonShapeOptions [m], thickness?: number [m], options?: PolygonShapeOptions", "Shape",
       "A plate whose outline is the convex hull of points in the scene's plane, else in that of x and y, which is at "
       "half its thickness.",
       "local wedge = shape.polygon { points = { vec(0, 0, 0), vec(2, 0, 0), vec(0, 1, 0) }, thickness = 0.5 }"},
      {"line", guard<line>, "points: vec[]|LineShapeOptions [m], options?: LineShapeOptions", "Shape",
       "A line through points in the scene's plane, else in that of x and y, and what lies before and behind it. It is "
       "one-sided: its front, on the left of who walks along it, bears things; through its back they pass. Points from "
       "left to right have their front above, as of ground; from right to left below, as of a ceiling. A closed line "
       "whose points go round anticlockwise holds things in, clockwise it keeps them out. For both sides give two "
       "lines, "
       "polygon. It does not move, so no body can have it.",
       "-- things rest on it:   1 -> 2 -> 3   and come through from below\n"
       "scene:ground { shape = shape.line({ vec(-5, -9, 0), vec(0, -9.5, 0), vec(5, -9, 0) }) }"},
      {"plane", guard<plane>, "options?: PlaneShapeOptions", "Shape",
       "A plane, solid behind it. It does not move, so no body can have it.",
       "scene:ground { shape = shape.plane { normal = vec(1, 0, 0), height = -9 } }"},
      {"mesh", guard<mesh>,
       "vertices: vec[]|Structure|MeshShapeOptions [m], faces?: integer[][], options?: MeshShapeOptions", "Shape",
       "Triangles, one-sided: their front is where their corners run counter-clockwise; from behind things come "
       "through. It does not move, so no body can have it.",
       "scene:ground { shape = shape.mesh(structure.sheet { columns = 4, rows = 4 }) }"},
      {"heights", guard<heights>, "options: HeightsShapeOptions", "Shape",
       "Heights over a grid in x and z, solid below. It does not move, so no body can have it.",
       "scene:ground { shape = shape.heights { columns = 20, rows = 20, spacing = 0.5,\n"
       "  height = function(x, z) return -9 + 0.1 * x * x end } }"},
  };
}

}  // namespace

const std::vector<Method>& shape_makers() {
  static const std::vector<Method> makers = make_all();
  return makers;
}

void open_shapes(lua_State* state, Script& script) {
  lua_newtable(state);
  for (const Method& maker : shape_makers()) {
    push_maker(state, maker, script);
    lua_setfield(state, -2, maker.name);
  }
  lua_newtable(state);
  lua_pushcfunction(state, guard<unknown_shape>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  lua_setglobal(state, "shape");
}

}  // namespace pantin::lua
