#pragma once
#include "world/world.hpp"

namespace pantin {

/// Notices a scene that goes back in time again and again, so that it never comes to its end.
class Headway {
 public:
  explicit Headway(const World& world);
  /// Call it after each step on the way to `until` [s]. Throws Error where the scene has come no farther for very long.
  void check(const World& world, double until);

 private:
  double begin_;         ///< [s]
  double farthest_;      ///< [s]
  double wasted_ = 0.0;  ///< [s] simulated since it was farthest
};

}  // namespace pantin
