#pragma once
// Bodies, particles and values as Lua writes them.
#include <string>
#include <vector>

#include "world/world.hpp"

namespace pantin::player {

/// Read back to the bit; "math.huge" where it is infinite.
std::string lua_of(double value);
std::string lua_of(Vec3 value);
/// In quotes, with what needs it escaped.
std::string quoted(const std::string& value);

/// A call that makes a thing, in parts, so that a row of them can be a loop.
struct LuaOfBody {
  std::string call;                  ///< "scene:box"; empty where it cannot be written
  std::string word;                  ///< "box": begins the name of a variable for it
  std::vector<std::string> options;  ///< "size = 1", without those below
  Vec3 at = zero3();                 ///< [m]
  Vec3 arm = zero3();                ///< [m] from there to its centre
  Vec3 centre = zero3();             ///< [m] `at` + `arm`, to the bit where that can be
  std::string color;                 ///< "#rrggbb"
  std::string why_not;               ///< the call is empty: why

  std::string whole() const { return with(lua_of(at), quoted(color)); }
  /// With other texts for where it is and for its colour.
  std::string with(const std::string& position, const std::string& its_color) const;
};
LuaOfBody lua_of_body(const World& world, BodyId body);
LuaOfBody lua_of_particle(const World& world, PointId free_point);
/// What a point is added to a body with: "(vec(1, 0, 0))", or " { at = …, mass = 1 }".
std::string lua_of_point(const Point& point);
/// Whether the point was made in one call with its body.
bool is_made_with(const World& world, PointId point);
/// "velocity = vec(1, 0, 0)": what was written to a body, or what it did, since it was as in `before`, by its properties.
std::vector<std::string> changes_of_body(const World& now, const World& before, BodyId body);

}  // namespace pantin::player
