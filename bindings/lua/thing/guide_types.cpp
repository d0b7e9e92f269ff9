// OnPlane, String, OnPath and Join.
#include "constraints/kind.hpp"
#include "lua/thing/constraint_fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "model/path.hpp"

namespace pantin::lua {
namespace {

Type make_on_plane() {
  return constraint_type({"OnPlane", "on_plane", "Keeps a point on a plane.", {}, {}},
                         {point_field(),
                          {"through", "vec", "m", "a position on the plane; the point is drawn to a new one",
                           [](const Self& s) { push(s.state, constraint_row(s).position); },
                           [](const Self& s, int i) {
                             set_position(s.world, constraint_of(s), check_vec(s.state, i, "on_plane", "through", "m"));
                           }},
                          {"normal", "vec", "1", "across the plane, of unit length",
                           [](const Self& s) { push(s.state, constraint_row(s).axis_a); },
                           [](const Self& s, int i) {
                             set_normal(s.world, constraint_of(s), check_vec(s.state, i, "on_plane", "normal", ""));
                           }},
                          force_field()});
}

void read_points(const Self& s) {
  lua_newtable(s.state);
  lua_Integer i = 0;
  for (const Passage& passage : constraint_row(s).passages) {
    if (passage.point)
      push_thing(s.state, s.script, passage.point);
    else
      push(s.state, passage.position);
    lua_rawseti(s.state, -2, ++i);
  }
}

Type make_string() {
  return constraint_type(
      {"String", "string", "Is at most so long along its points; slides through the inner ones.", {}, {}},
      {{"points", "(Point|vec)[]", "m", "what it goes through: points, or positions", read_points, nullptr},
       {"length", "number", "m",
        "the most that it is long; written as a number or a function of time "
        "[s]",
        [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).length); },
        [](const Self& s, int i) {
          auto given = check_number_of_time(s, i, "string", "length", "m");
          set_length(s.world, constraint_of(s), given.value, std::move(given.function));
        }},
       {"taken", "number", "m", "how long its way is now: less than its length where it is slack",
        [](const Self& s) { lua_pushnumber(s.state, present_value(s.world, constraint_row(s))); }, nullptr},
       {"force", "number", "N", "tension in the last step, 0 where it is slack",
        [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).tension); }, nullptr}});
}

void read_path(const Self& s) {
  lua_newtable(s.state);
  lua_Integer i = 0;
  for (const Vec3& place : constraint_row(s).path->positions()) {
    push(s.state, place);
    lua_rawseti(s.state, -2, ++i);
  }
}

Type make_on_path() {
  return constraint_type({"OnPath", "on_path", "Keeps a point on a path.", {}, {}},
                         {point_field(),
                          {"path", "vec[]", "m", "the positions that the path goes through", read_path, nullptr},
                          {"along", "number", "1",
                           "where on the path the point is: 0 at the first position, 1 at the "
                           "second, and so on",
                           [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).along); }, nullptr},
                          force_field()});
}

Type make_join() {
  return constraint_type(
      {"Join", "join", "Draws two points together, to join them into a hinge.", {}, {}},
      {{"a", "Point", "", "the first point", [](const Self& s) { push_if(s, constraint_row(s).a); }, nullptr},
       {"b", "Point", "", "the second point", [](const Self& s) { push_if(s, constraint_row(s).b); }, nullptr},
       {"max_force", "number", "N", "it never pulls harder; math.huge: no limit",
        [](const Self& s) { lua_pushnumber(s.state, constraint_row(s).max_force); }, nullptr},
       force_field()});
}

}  // namespace

const Type& on_plane_type() {
  static const Type type = make_on_plane();
  return type;
}
const Type& string_type() {
  static const Type type = make_string();
  return type;
}
const Type& join_type() {
  static const Type type = make_join();
  return type;
}
const Type& on_path_type() {
  static const Type type = make_on_path();
  return type;
}

}  // namespace pantin::lua
