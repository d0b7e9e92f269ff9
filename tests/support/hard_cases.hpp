#pragma once
// Scenes that solvers fail at: lattices of redundant hinges, welds of three hinges, hubs, random trees of any masses.
#include <vector>

#include "base/random.hpp"
#include "support/cases.hpp"

namespace pantin::cases {

/// Uniform in [low, high).
inline double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }
/// 10 to a power uniform in [-decades, decades).
double of_any_size(Random& random, double decades);
Vec3 vector_within(Random& random, double size);  ///< each component in [-size, size)

/// `side` × `side` unit squares of 1 kg in the plane z = 0, without gravity, turned by ± `turn` [rad] so that neighbours
/// share corners; they all turn as one. One corner of the first is nailed; `corner` is the opposite one of the last.
struct Squares {
  std::vector<BodyId> bodies;
  PointId corner;
  Vec3 away = zero3();  ///< direction from the nail to `corner`
};
Squares add_squares(World& world, int side, double turn);

/// Unit rods along x, each welded to the last, and the first to the world, by three hinges 0.05 m apart. Returns the tip.
PointId add_cantilever(World& world, int links);

/// A disc of 10 kg and radius 1 m, nailed at its centre, with `spokes` unit rods hinged all round it.
struct Hub {
  BodyId disc;
  std::vector<BodyId> spokes;
};
Hub add_hub(World& world, int spokes);

/// A chain pinned at one end, of links with masses of ± `decades` powers of ten.
Chain add_mixed_chain(World& world, int links, Random& random, double decades);

/// Boxes, rods, two masses, single points, each hinged at a random point of the others; the first one may be nailed.
/// With `loops`, rods between random points.
struct Tangle {
  std::vector<BodyId> bodies;
  std::vector<PointId> points;
  std::vector<ParticleId> hinges;
};
Tangle add_tangle(World& world, Random& random, int bodies, double decades, int loops);

}  // namespace pantin::cases
