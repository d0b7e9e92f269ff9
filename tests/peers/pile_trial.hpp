#pragma once
// One engine with one setting on one pile: what it costs and what becomes of the pile, measured alike for every engine from
// the poses and velocities that it tells.
#include <string>
#include <utility>
#include <vector>

#include "peers/trial.hpp"
#include "shapes/shape.hpp"

namespace pantin::peers {

inline constexpr double pile_rate = 240.0;  ///< [1/s] steps
inline constexpr double pile_moves = 3.0;   ///< [s] "in motion": from the start until then
inline constexpr double pile_rests = 6.0;   ///< [s] "at rest": from then on
inline constexpr double pile_end = 8.0;     ///< [s]
inline constexpr double still = 0.05;       ///< [m/s] a pile is settled once no centre is faster

/// As far as it was reached; NaN where it was not.
struct Stretch {
  double step = 0.0;      ///< [ns] of the processor, per step
  double contacts = 0.0;  ///< per step, as the engine counts them
  double overlap = 0.0;   ///< [m] the deepest, of each fourth step
  double per_contact() const { return step / contacts; }
};

struct PileTrial {
  Stretch moving, rest;
  double creep = 0.0;      ///< [m] by which any centre was farthest from where it was when the rest began
  double settled = 0.0;    ///< [s] infinite: not until the end
  double rise = 0.0;       ///< [J] the largest of the energy (kinetic, and in gravity) in a step
  double gap = 0.0;        ///< [m] the largest of a joint
  double unsolved = 0.0;   ///< islands that the engine says it did not solve
  double simulated = 0.0;  ///< [s]
  std::string trouble;     ///< not empty: it failed after `simulated`

  /// Every number by its name, to be written and read.
  std::vector<std::pair<const char*, double*>> numbers();
};

/// Of several falls of one pile: means of times and contacts, the largest of what else is measured, all that is unsolved.
PileTrial together(const std::vector<PileTrial>& falls);

/// Ends at `until` [s], or once it has used so much of the processor [s].
PileTrial run_pile(const Setting& setting, const Mechanism& pile, double until, double most);

/// A solid's shape. Throws std::invalid_argument where it has none.
Geometry geometry_of(const SolidDef& solid);

/// [m] The deepest overlap of solids with walls and each other, by Pantin's geometry; 0 where nothing overlaps.
double deepest_overlap(const Mechanism& pile, const std::vector<SolidState>& state);

}  // namespace pantin::peers
