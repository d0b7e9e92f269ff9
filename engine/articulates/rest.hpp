#pragma once
// What an articulate at rest is known by. It sleeps once its motion has died away: nothing moves it then, and what would
// wakes it.
#include <cstdint>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// What laws do to a node: [N], [N m] about its centre, world axes.
struct NodePull {
  Vec3 force = zero3(), torque = zero3();                                  ///< of laws with energy
  Vec3 nonconservative_force = zero3(), nonconservative_torque = zero3();  ///< of those without
};

struct Rest {
  bool asleep = false;
  std::uint32_t steps = 0;      ///< since its motion was looked at
  double peak = 0.0;            ///< [J] largest kinetic energy since then
  double last_peak = -1.0;      ///< [J] the same before; < 0: not known
  double acceleration = 0.0;    ///< [m/s²] while it sleeps: what moves it by more wakes it
  std::vector<NodePull> pulls;  ///< while it sleeps: (nodes); none where no law acts
  std::uint32_t receivers = 0;  ///< while it sleeps: nodes on which laws act
};

}  // namespace pantin
