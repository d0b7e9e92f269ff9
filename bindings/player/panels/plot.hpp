#pragma once
#include <vector>

#include "player/table.hpp"

namespace pantin::player {

/// The stretch of time that plots show: all of it until somebody zooms.
struct PlotRange {
  double from = 0.0, to = 1.0;  ///< [s]
  bool all = true;              ///< from the start to now
};

/// Brings the range up to now.
void follow(PlotRange& range, const Times& times);

/// A probe over time, as wide as there is room: the wheel zooms in time about the pointer, dragging shifts, a double
/// click shows all. `high` [px].
void plot(const Probe& probe, const Times& times, PlotRange& range, float high);

}  // namespace pantin::player
