#pragma once
#include <vector>

#include "base/lanes.hpp"

namespace pantin::cases {

/// The start of the Lennard-Jones melt of LAMMPS' benchmarks (bench/in.lj): a face-centred cubic crystal of density
/// 0.8442 in a periodic box, atoms in the order of LAMMPS' numbers, with the velocities of
/// `velocity all create 1.44 87287 loop geom`, which hashes positions into seeds of Park and Miller's generator.
struct Melt {
  explicit Melt(int cells = 20);
  double edge = 0.0;  ///< of the box
  std::vector<Vec3> positions, velocities;
};

}  // namespace pantin::cases
