#pragma once
// What sweeps over contacts work on; see sweeps.cpp.
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/vectors4.hpp"

namespace pantin {

/// M^½ v of a body: of its centre, of its spin.
struct Scaled {
  Vec3 centre = zero3(), spin = zero3();
};

/// Four contacts of which no two share a body, with their rows of J: (columns) what they read of spins; of centres it is the
/// frame times `by`. A lane without a contact has zeros, and the world for bodies.
struct ContactBatch {
  Mat3x4 frame, spin_a, spin_b;
  Lanes by_a, by_b;  // [kg^-½]
  std::array<std::uint32_t, batch_size> a, b;
  Vec3x4 impulse, bias;
  Vec3x4 before, conjugate;  // [N s] before this sweep; conjugate direction
  Lanes friction, compliance;
  Lanes w00, w01, w02, w11, w12, w22;  // [1/kg] J J'
  Lanes i11, i12, i22;                 // [kg] inverse of the part across n
  Lanes wt;                            // [1/kg] its largest eigenvalue
  Lanes i00, it;                       // [kg] 1/(w00 + compliance), 1/wt
};

/// Friction against spins at one of them: (columns) what it reads of spins.
struct RollBlock {
  Mat3 spin_a, spin_b;
  std::uint32_t contact = 0;  // its position
  Vec3 impulse = zero3(), before = zero3(), conjugate = zero3();
  double wn = 0.0, wt = 0.0;  // [1/kg]
};

/// What a scalar reads of a body, and gives it.
struct ScalarBlock {
  std::uint32_t body = 0;
  Vec3 centre = zero3(), spin = zero3();
};

struct SweepSpace {
  std::vector<Scaled> free, y, before, conjugate;  ///< (bodies and, last, a world for each half, which stays 0)
  std::vector<ContactBatch> batches;    ///< of the halves and of what is between them, each from the lowest up
  std::array<std::size_t, 3> end = {};  ///< where the batches of each part end
  std::vector<std::uint8_t> half;       ///< (bodies)
  std::vector<double> along;            ///< (bodies) [m] scratch
  std::vector<std::uint32_t> position;  ///< (contacts) batch times four, and lane
  std::vector<std::pair<double, std::uint32_t>> by_height;  ///< contacts
  std::vector<std::uint32_t> next_batch;                    ///< (bodies) the first after the last that has it
  std::vector<std::uint32_t> with_room,
      occupied;  ///< (batches) union-find: the first from here with a free lane; lanes in use
  std::vector<RollBlock> rolls;
  std::vector<Vec3> tie_before, tie_conjugate;
  std::vector<ScalarBlock> scalars;  ///< (ends of the island's scalars)
  std::vector<double> scalar_before, scalar_conjugate;
};

}  // namespace pantin
