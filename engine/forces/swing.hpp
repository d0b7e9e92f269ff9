#pragma once
// How far a thing swings beside a uniform motion: what errors are relative to where it interacts with nothing.
#include <cstdint>

#include "base/lanes.hpp"

namespace pantin {

/// Sums over the positions where a thing was seen, from the first of them.
struct Swing {
  std::uint64_t serial = 0;  ///< of the particle; 0: none yet
  Vec3 first = zero3();      ///< [m]
  double since = 0.0;        ///< [s]
  bool begun = false;
  double acceleration = 0.0, jerk = 0.0;  ///< [m/s²], [m/s³] the largest at ends of steps
  double n = 0.0, t = 0.0, tt = 0.0;      ///< steps
  Vec3 x = zero3(), xt = zero3();
  Vec3 squares = zero3(), products = zero3();  ///< x², y², z² and xy, yz, zx

  void add(Vec3 position, double time, double weight);
  /// From end to end, along a direction, as a sine swings that strays as much from a uniform motion [m].
  double along(Vec3 direction) const;
};

}  // namespace pantin
