#pragma once
#include "measure/measure.hpp"

namespace pantin {

/// What things can do: their own freedoms, less what ties among them take, and less their common motion along what
/// directions nothing holds them in.
struct FreedomCount {
  long count = 0;
  Mat3 loose =
      identity33();  ///< takes from a vector what is along a direction in which something holds them: a nail, a
                     ///< rigid follow or a rod to a position in all, a plane along its normal, a path across it
  long common = 3;   ///< directions of `loose`
};
FreedomCount count_freedoms(const World& world, const Things& things);

}  // namespace pantin
