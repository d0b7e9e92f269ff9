#include "choreography/hands.hpp"

#include "lua/arguments.hpp"
#include "lua/fields.hpp"
#include "lua/guard.hpp"
#include "lua/script.hpp"
#include "lua/targets.hpp"

namespace pantin::lua {
namespace {

std::int32_t index_of(const Self& self) { return static_cast<std::int32_t>(self.ref.slot) - 1; }
const Hand& row(const Self& self) { return self.world.hands[self.ref.slot - 1]; }

int grab_point(lua_State* state) {
  const Self self = check_self(state, Kind::hand, "grab");
  const PointId point = check_point(state, 2, "grab", argument(1));
  const Options o(state, 3, "grab", {"max_force"});
  grab(self.world, index_of(self), point, o.number_or_infinity("max_force", "N"));
  return 0;
}

int release_point(lua_State* state) {
  const Self self = check_self(state, Kind::hand, "release");
  release(self.world, index_of(self));
  return 0;
}

Type make() {
  Type type{"Hand", "hand", "What can grab: the mouse, a finger, a stick, a script's.", {}, {}};
  type.fields = {
      {"position", "vec", "m", "place in the world", [](const Self& s) { push(s.state, row(s).position); }, nullptr},
      {"velocity", "vec", "m/s", "velocity over the last step", [](const Self& s) { push(s.state, row(s).velocity); },
       nullptr},
      {"pressed", "boolean", "", "whether its button is down",
       [](const Self& s) { lua_pushboolean(s.state, row(s).pressed); }, nullptr},
  };
  type.methods = {
      {"grab", guard<grab_point>, "point: Point, options?: { max_force: number }", "",
       "Takes hold of a point with at most max_force [N]; lets go of what it held."},
      {"release", guard<release_point>, "", "", "Lets go."},
  };
  return type;
}

}  // namespace

const Type& hand_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
