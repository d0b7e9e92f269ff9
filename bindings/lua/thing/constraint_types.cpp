// Nail, follow and rod.
#include "edit/edit.hpp"
#include "lua/thing/constraint_fields.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/point_constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

ConstraintId id_of(const Self& self) { return constraint_of(self); }
Constraint& row(const Self& self) { return constraint_row(self); }

Type make_nail() {
  return constraint_type(
      {"Nail", "nail", "Keeps a point at a position of the world.", {}, {}},
      {point_field(),
       {"at", "vec", "m", "the position; the point is drawn to a new one",
        [](const Self& s) { push(s.state, row(s).position); },
        [](const Self& s, int i) { set_position(s.world, id_of(s), check_vec(s.state, i, "nail", "at", "m")); }},
       force_field()});
}

Type make_follow() {
  return constraint_type(
      {"Follow", "follow", "Keeps a point to a moving target; with max_force it never pulls harder.", {}, {}},
      {point_field(),
       {"target", "vec", "m", "where the target is; written as a vec or a function of time [s]",
        [](const Self& s) { push(s.state, row(s).position); },
        [](const Self& s, int i) {
          if (lua_isfunction(s.state, i))
            set_target(s.world, id_of(s), place_of_time(Callback(s.state, i), "follow: target"));
          else
            set_position(s.world, id_of(s), check_vec(s.state, i, "follow", "target", "m"));
        }},
       {"max_force", "number", "N", "never pulls harder; math.huge: no limit",
        [](const Self& s) { lua_pushnumber(s.state, row(s).max_force); },
        [](const Self& s, int i) {
          set_max_force(s.world, id_of(s), check_number_or_infinity(s.state, i, "follow", "max_force", "N"));
        }},
       force_field()});
}

Type make_rod() {
  return constraint_type(
      {"Rod", "rod", "Keeps two points, or a point and a position, at a distance.", {}, {}},
      {{"a", "Point", "", "its first point", [](const Self& s) { push_if(s, row(s).a); }, nullptr},
       {"b", "Point?", "", "its second point, or nil where that end is a position",
        [](const Self& s) { push_if(s, row(s).b); }, nullptr},
       {"at", "vec", "m", "position of its second end; written where no point is there",
        [](const Self& s) { push(s.state, row(s).b ? position(s.world, row(s).b) : row(s).position); },
        [](const Self& s, int i) {
          require(!row(s).b, "rod: at can be written only of a rod whose end is a position; this one ends at a point");
          set_position(s.world, id_of(s), check_vec(s.state, i, "rod", "at", "m"));
        }},
       {"length", "number", "m", "the distance that it keeps; written as a number or a function of time [s]",
        [](const Self& s) { lua_pushnumber(s.state, row(s).length); },
        [](const Self& s, int i) {
          auto given = check_number_of_time(s, i, "rod", "length", "m");
          set_length(s.world, id_of(s), given.value, std::move(given.function));
        }},
       {"force", "number", "N", "tension in the last step, > 0 when it pulls",
        [](const Self& s) { lua_pushnumber(s.state, row(s).tension); }, nullptr}});
}

}  // namespace

const Type& nail_type() {
  static const Type type = make_nail();
  return type;
}
const Type& follow_type() {
  static const Type type = make_follow();
  return type;
}
const Type& rod_type() {
  static const Type type = make_rod();
  return type;
}

}  // namespace pantin::lua
