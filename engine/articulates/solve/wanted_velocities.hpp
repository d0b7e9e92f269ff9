#pragma once
#include <tuple>
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// Velocities that conditions want at a moment `at` (0 … 1) of a step of `step` [s], by what they want at its end and on the way; at
/// the end again when this goes.
class WantedVelocities {
 public:
  WantedVelocities(Articulate& articulate, double step, double at);
  ~WantedVelocities();
  WantedVelocities(const WantedVelocities&) = delete;
  WantedVelocities& operator=(const WantedVelocities&) = delete;

 private:
  Articulate& a_;
  std::vector<std::tuple<Vec3, double, double>> at_end_;
};

}  // namespace pantin
