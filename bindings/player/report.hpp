#pragma once
#include <string>

#include "player/options.hpp"
#include "player/study.hpp"

namespace pantin::player {

inline constexpr double report_budget = 30.0;  ///< [s] of processor time

/// `pantin report`: speed against error of a scene, to standard output, PREFIX.json and PREFIX.svg. Returns the exit code.
int report(const RunOptions& options, const std::string& prefix, const std::string& home);

/// The table of the runs and what follows from it, ending with what to choose.
std::string report_text(const Study& study, double product_ns);
/// The last sentence of it.
std::string advice(const Study& study);
std::string report_json(const Study& study, double product_ns);
/// SVG: error against cost, and against the step.
std::string report_picture(const Study& study);

}  // namespace pantin::player
