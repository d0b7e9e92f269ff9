#include "choreography/hands.hpp"

#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

std::int32_t index_of(const Self& self) { return static_cast<std::int32_t>(self.ref.slot) - 1; }
const Hand& hand_row(const Self& self) { return self.world.hands[self.ref.slot - 1]; }

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

Type make_hand_type() {
  Type type{"Hand", "hand", "What can grab: the mouse, a finger, a stick, a script's.", {}, {}};
  type.fields = {
      {"position", "vec", "m", "position in the world", [](const Self& s) { push(s.state, hand_row(s).position); },
       nullptr},
      {"velocity", "vec", "m/s", "velocity over the last step",
       [](const Self& s) { push(s.state, hand_row(s).velocity); }, nullptr},
      {"pressed", "boolean", "", "whether its button is down",
       [](const Self& s) { lua_pushboolean(s.state, hand_row(s).pressed); }, nullptr},
  };
  type.methods = {
      {"grab", guard<grab_point>, "point: Point|Particle, options?: GrabOptions", "",
       "Takes hold of a point; lets go of what it held.",
       "local hand = scene:hand { path = function(t) return vec(-2 + t, 1, 0) end }\n"
       "hand:grab(p, { max_force = 20 })"},
      {"release", guard<release_point>, "", "", "Lets go.",
       "local hand = scene:hand()\n"
       "scene:at(1, function() hand:release() end)"},
  };
  return type;
}

}  // namespace

const Type& hand_type() {
  static const Type type = make_hand_type();
  return type;
}

}  // namespace pantin::lua
