#pragma once
#include <cmath>
#include <limits>

namespace pantin {

/// Load at which a constraint or a hinge breaks; infinite: never.
struct Breaking {
  double force = std::numeric_limits<double>::infinity();   ///< [N] > 0
  double torque = std::numeric_limits<double>::infinity();  ///< [N m] > 0
  double length = std::numeric_limits<double>::infinity();  ///< [m] > 0, distance between the ends
  bool possible() const { return std::isfinite(force) || std::isfinite(torque) || std::isfinite(length); }
};

}  // namespace pantin
