#pragma once
// What sweeps over contacts work on; see sweeps.cpp.
#include <cstdint>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// M^½ v of a body: of its centre, of its spin.
struct Scaled {
  Vec3 centre = zero3(), spin = zero3();
};

/// One contact, with its rows of J: (columns) what they read of spins; of centres it is the frame times `by`.
struct ContactBlock {
  Mat3 frame, spin_a, spin_b;
  double by_a = 0.0, by_b = 0.0;  // [kg^-½]
  std::uint32_t a = 0, b = 0;
  Vec3 impulse = zero3(), bias = zero3();
  Vec3 before = zero3(), way = zero3();  // [N s] before this sweep; conjugate direction
  double friction = 0.0, compliance = 0.0;
  double w00 = 0.0, w01 = 0.0, w02 = 0.0, w11 = 0.0, w12 = 0.0, w22 = 0.0;  // [1/kg] J J'
  double i11 = 0.0, i12 = 0.0, i22 = 0.0;                                   // [kg] inverse of the part across n
  double wt = 0.0;                                                          // [1/kg] its largest eigenvalue
  double i00 = 0.0, it = 0.0;                                               // [kg] 1/(w00 + compliance), 1/wt
  std::uint32_t idle = 0;
};

/// Friction against spins at one of them: (columns) what it reads of spins.
struct RollBlock {
  Mat3 spin_a, spin_b;
  std::uint32_t contact = 0;  // index of the block
  Vec3 impulse = zero3(), before = zero3(), way = zero3();
  double wn = 0.0, wt = 0.0;  // [1/kg]
};

/// What a scalar reads of a body, and gives it.
struct ScalarBlock {
  std::uint32_t body = 0;
  Vec3 centre = zero3(), spin = zero3();
};

struct SweepSpace {
  std::vector<Scaled> free, y, before, way;  ///< (bodies and, last, the world, which stays 0)
  std::vector<ContactBlock> blocks;          ///< from the lowest up
  std::vector<std::uint32_t> order;          ///< (blocks) index of the contact
  std::vector<RollBlock> rolls;
  std::vector<Vec3> tie_before, tie_way;
  std::vector<ScalarBlock> scalars;  ///< (ends of the island's scalars)
  std::vector<double> scalar_before, scalar_way;
};

}  // namespace pantin
