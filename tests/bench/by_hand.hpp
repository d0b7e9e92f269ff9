#pragma once
// What laws are measured against: loops written for one law each, in which everything stays in registers.
#include "laws/run/bonds.hpp"
#include "laws/run/sites.hpp"
#include "support/melt.hpp"

namespace pantin::by_hand {

enum class Law {
  lennard_jones,    ///< 4 (r⁻¹² - r⁻⁶)
  four_attributes,  ///< 4 d_a d_b (s¹² - s⁶), s = (s_a + s_b) / r
  smooth_switch,    ///< the first, led smoothly to 0 from r = 2 to 2.5
};

/// Moves a melt by velocity Verlet, with neighbour rows that are built anew when the skin is spent; gives the time of
/// one thread's processor [s].
double run_melt(const cases::Melt& melt, int steps, Law law);

/// Springs k (r - l), the parameters of ties.
void add_springs(Sites& sites, const BondList& ties);

}  // namespace pantin::by_hand
