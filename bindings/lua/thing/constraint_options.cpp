#include "lua/thing/constraint_options.hpp"

#include "lua/thing/handles.hpp"

namespace pantin::lua {

const ConstraintCall axis_call = {};

std::vector<const ConstraintCall*> constraint_calls() {
  std::vector<const ConstraintCall*> calls = {
#define CONSTRAINT_KIND(name) &name##_call,
#include "model/constraint_kinds.hpp"
  };
  std::erase(calls, &axis_call);
  return calls;
}

Options tie_options(lua_State* state, int index, std::string what, std::vector<std::string> names) {
  names.insert(names.end(), {"name", "breaks_at"});
  Options o(state, index, std::move(what), names);
  require(!lua_istable(state, index) || lua_isnoneornil(state, index + 1), o.what(), ": its options come last, got ",
          kind_of_value(state, index + 1), " after them");
  return o;
}

int finish(const Self& self, ConstraintId id, const Options& o) {
  try {
    self.world.constraints[id].name = o.string("name").value_or("");
    if (o.has("breaks_at"))
      set_breaks_at(self.world, id, check_breaking(self.state, o.push("breaks_at"), o.what() + ": breaks_at"));
  } catch (...) {
    remove(self.world, id);
    throw;
  }
  push_thing(self.state, self.script, id);
  return 1;
}

Vec3 axis_option(const Self& self, const Options& o) {
  const Plane& plane = self.world.plane;
  require(o.has("axis") || plane.flat(), o.what(), ": axis must be given, a vec in world axes");
  return o.has("axis") ? *o.vector("axis", "") : plane.about(vec(1, 1, 1));
}

}  // namespace pantin::lua
