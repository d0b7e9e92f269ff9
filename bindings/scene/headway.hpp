#pragma once
#include "world/world.hpp"

namespace pantin {

/// Notices a scene that goes back in time again and again, so that it never comes to its end.
class Headway {
 public:
  Headway(const World& world, double until);  ///< [s]
  /// Call it after each step. Throws Error where the scene has come no farther for very long.
  void check(const World& world);

 private:
  double until_;         ///< [s]
  double farthest_;      ///< [s]
  double longest_;       ///< [s] that are simulated without coming farther
  double wasted_ = 0.0;  ///< [s] simulated since it was farthest
};

}  // namespace pantin
