#pragma once
// How far two runs are from each other.
#include <vector>

#include "player/study.hpp"

namespace pantin::player {

/// Over the things that two runs have at a time, [m]; NaN where there are none.
struct Gap {
  double mean = std::numeric_limits<double>::quiet_NaN();  ///< root mean square
  double most = std::numeric_limits<double>::quiet_NaN();
};

/// Over the times that both reached, [m].
std::vector<double> gaps(const StudyRun& a, const StudyRun& b, double Gap::*of);

/// The same, the largest so far at each time, until one is no number.
std::vector<double> rising_gaps(const StudyRun& a, const StudyRun& b, double Gap::*of);

/// The largest of a list over the times until one, [s].
double largest_until(const Study& study, const std::vector<double>& list, double until);

/// [s] of the last time before one of the list exceeds `limit`.
double last_within(const Study& study, const std::vector<double>& list, double limit);

}  // namespace pantin::player
