#pragma once
#include <functional>

#include "world/world.hpp"

namespace pantin {

/// Calls what a join calls with the hinge that it became.
struct TellMet {
  ParticleId hinge;
  std::function<void(ParticleId)> on_met;
  void operator()() const { on_met(hinge); }
};

/// Makes the hinges of joins whose points met in the step just done.
void make_met_hinges(World& world);

}  // namespace pantin
