#pragma once
// By how much the finest runs may be wrong themselves, by how far runs are from each other.
#include "player/gaps.hpp"

namespace pantin::player {

constexpr double apart = 0.01;  // of the size: runs that are further from each other show different motions

/// The finest run of a series that came to the end, and by how much it may be wrong.
struct Doubted {
  std::size_t run = 0;
  std::vector<double> doubt;  ///< [m] at each time, the largest until then; infinite where no three runs tell
};

/// Of each series; of the paper's integrator only where it is alone: it is of first order, and what it dissipates hides
/// chaos.
std::vector<Doubted> doubts(const Study& study, double Gap::*of);

/// The run of the same integrator with the next longer step, or null; of what chooses its own steps always null.
const StudyRun* coarser(const Study& study, std::size_t i);

}  // namespace pantin::player
