#pragma once
// Sub-steps by a measured local error: a thing is moved over a stretch of time by its number of sub-steps and by twice as
// many; of the order p, the first ones are wrong by 2^p/(2^p - 1) of the difference (Richardson 1911). That is done now and
// then, and wherever the motion changes more suddenly than the last trials bear: a midpoint step of h is wrong by h³/12
// times a jerk or so.
#include <algorithm>
#include <cmath>

#include "articulates/articulate.hpp"

namespace pantin {

inline constexpr std::uint16_t sub_step_limit = 256;

struct SubStepSettings {
  double accuracy = 0.0;  ///< [1/s] largest error of a point per second, relative to the thing's length; 0: fixed steps
  bool may_try = true;    ///< this is the first stage of a step
  double span = 0.0;      ///< [s] between like stages, to difference mean motions; 0: this stage looks for no jerk
};

/// [m] from the centre of points that show how a node turns.
inline double extent(const Node& n) {
  return n.turns ? std::max(n.reach, std::sqrt(largest(n.inertia) * n.inverse_mass)) : 0.0;
}

/// Where trials happen.
struct Trial {
  Articulate start, other;
  std::vector<MeanMotion> means;
};

/// Moves a loaded articulate over the settings' stage of the step by as many sub-steps as the accuracy wants. What it did is
/// in its report; `unreached` tells that not even the most were enough.
void drift_accurately(Articulate& articulate, const DriftSettings& settings, const SubStepSettings& wanted,
                      Trial& trial);
/// The same for a node without rows over h [s]; returns the error where not even the most are enough, else 0 [1/s].
double drift_alone_accurately(Node& node, double h, const SubStepSettings& wanted, SubSteps& sub_steps);

/// Sets a number of sub-steps by the error rate that it has [1/s], known once a step; false where the most are not enough.
bool adapt(SubSteps& sub_steps, double rate, double accuracy);

}  // namespace pantin
