#pragma once
#include "contacts/solve/island.hpp"

namespace pantin {

/// Impulses of an island to come back to.
struct BestImpulses {
  double residual = infinity;  ///< [m/s]
  std::vector<Vec3> contacts, rolls, ties;
  std::vector<double> scalars;

  void keep(const ContactIsland& island, double now = infinity);
  /// With the velocities that they make.
  void put_back(ContactIsland& island) const;
};

}  // namespace pantin
