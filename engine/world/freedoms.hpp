#pragma once
#include "world/measure.hpp"

namespace pantin {

/// What things can do: their own freedoms, less what ties among them take, and less their common motion where nothing
/// holds them.
struct FreedomCount {
  long count = 0;
  bool held = false;  ///< by a nail, a rigid follow, or a rod to a place
};
FreedomCount count_freedoms(const World& world, const Things& things);

}  // namespace pantin
