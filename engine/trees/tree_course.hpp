#pragma once
// The state of a tree of hinges, and its way in time.
#include <array>

#include "base/aligned.hpp"
#include "base/vectors4.hpp"

namespace pantin {

struct Tree;
struct TreeWorkspace;

/// Orientations of four nodes, not of unit length, and their spins in world axes [rad/s]; or the rates of both.
struct Rotation4 {
  Quatx4 q;
  Vec3x4 w;
};
using TreeState = AlignedVector<Rotation4>;  ///< (batches)

/// The last step that a tree took, and where the present is in it.
struct TreeCourse {
  TreeState end;                          ///< of it, of unit length
  TreeState end_rates;                    ///< the rates there
  std::array<TreeState, 8> coefficients;  ///< of its polynomial, the first is its start
  double h = 0.0;                         ///< [s] its length
  double ahead = 0.0;                     ///< [s] by which its end is after the present
  double next = 0.0;                      ///< [s] length of the next; 0: not known
  double own_rate2 = 0.0;                 ///< [1/s²] see `largest_own_rate2`, at its end
  bool fresh = true;                      ///< nothing but `end` is known, and that is the present
};

}  // namespace pantin
