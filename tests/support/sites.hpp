#pragma once
// Sites at random positions, for tests of laws.
#include <cstdint>

#include "base/random.hpp"
#include "laws/run/cells.hpp"
#include "laws/run/sites.hpp"

namespace pantin::cases {

struct RandomSites {
  std::size_t count = 500;
  double edge = 10.0;  ///< [m] of the cube they are in
  double speed = 0.0;  ///< [m/s] of each component, at most
  std::uint32_t families = 1;
  std::uint64_t seed = 1;
  double cell = 1.0;  ///< [m] width of the cells that they are sorted by
};

/// Has the attributes "charge" and "radius", in [0.5, 1.5).
inline Sites random_sites(const RandomSites& def = {}) {
  Random random{def.seed};
  const auto cube = [&](double edge) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    return vec(x, y, z) * edge;
  };
  Sites sites;
  sites.names = {"charge", "radius"};
  sites.resize(def.count);
  sites.clear_forces();
  for (std::size_t i = 0; i < sites.n; i++) sites.x[i] = cube(def.edge);
  const std::vector<std::uint32_t> order = cell_order({sites.x.data(), sites.n}, {}, def.cell);
  const AlignedVector<Vec3> x = sites.x;
  for (std::size_t i = 0; i < sites.n; i++) {
    sites.x[i] = x[order[i]];
    sites.v[i] = (cube(2.0) - vec(1, 1, 1)) * def.speed;
    sites.particle[i] = static_cast<std::uint32_t>(i);
    sites.serial[i] = i + 1;
    sites.family[i] = static_cast<std::uint32_t>(i % def.families);
    sites.kin[i] = {};
    sites.attributes[0][i] = 0.5 + random.uniform();
    sites.attributes[1][i] = 0.5 + random.uniform();
  }
  return sites;
}

}  // namespace pantin::cases
