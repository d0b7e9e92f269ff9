#pragma once
#include <functional>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// What a run was like, measured from outside after every step.
struct Watched {
  double gap = 0.0;            ///< [m] largest distance between points that should coincide, at any step
  double energy_change = 0.0;  ///< [J] largest |energy - start|
  double kinetic = 0.0;        ///< [J] largest kinetic energy
  double worst_error = 0.0;    ///< largest |energy - start| / largest kinetic energy until then
  bool finite = true;          ///< every position and velocity was a number after every step
  std::string failure;         ///< World::failure at the end
  double energy_error() const { return energy_change / kinetic; }
};

/// Steps until `time` [s], calling `each` after every step; stops at a failure.
Watched watch(World& world, double time, const std::function<void()>& each = {});

/// Largest distance between points of one hinge, and of nailed points to their positions, [m].
double largest_gap(const World& world);
bool all_finite(const World& world);
/// The power of x that y grows with: slope of log y over log x by least squares.
double exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace pantin
