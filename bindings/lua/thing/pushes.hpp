#pragma once
// `push` and `kick` of a point, and of a particle, which is pushed at the point that stands for it.
#include <vector>

#include "edit/edit.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {

template <Kind kind>
int push_force(lua_State* state) {
  const Self self = check_self(state, kind, "push");
  const PointId point = check_point(state, 1, "push", type_of(kind).word);
  push(self.world, point, check_vec(state, 2, "push", "force", "N"));
  return 0;
}

template <Kind kind>
int kick_at_once(lua_State* state) {
  const Self self = check_self(state, kind, "kick");
  const PointId point = check_point(state, 1, "kick", type_of(kind).word);
  kick(self.world, point, check_vec(state, 2, "kick", "impulse", "N s"));
  return 0;
}

template <Kind kind>
std::vector<Method> pushes() {
  return {
      {"push", guard<push_force<kind>>, "force: vec [N]", "", "Pulls for the coming step.",
       kind == Kind::point ? "scene:on(\"step\", function() arm.head:push(vec(0, 10, 0)) end)"
                           : "scene:on(\"step\", function() p:push(vec(0, 10, 0)) end)"},
      {"kick", guard<kick_at_once<kind>>, "impulse: vec [N s]", "",
       "Changes the velocity at once. What ties take of that is in no force of theirs, and breaks none: a push does.",
       kind == Kind::point ? "arm.head:kick(vec(0, 0.5, 0))" : "p:kick(vec(0, 0.5, 0))"}};
}

}  // namespace pantin::lua
