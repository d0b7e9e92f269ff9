#pragma once
// Cases that one process runs one after the other: to share out each by itself costs a part of what a short one takes.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "player/sweep/row.hpp"

namespace pantin::player {

/// A case that is to be run: its number, and what is set.
struct CaseOrder {
  std::uint64_t number = 0;
  Cells set;
};
using Bundle = std::vector<CaseOrder>;

constexpr double bundle_time = 0.1;  ///< in which the cases of a bundle begin, s of the clock

struct BundleResult {
  std::vector<CaseRow> rows;  ///< of the first cases; none: the process ended that ran them
  Bundle left;                ///< the others, which are to be run yet
  double seconds = 0.0;       ///< that the rows took, by the clock
};

std::string text_of(const Bundle& bundle);
/// Runs the first case, and those after it that begin in time. Bundle and result are texts.
std::string run_bundle(const std::string& bundle, const std::function<CaseRow(const CaseOrder&)>& run);
/// Where the process ended that ran them, and how: a row, if it was one case; else, which of them it was is not known.
std::string result_of_dead(const std::string& bundle, const std::string& how);
BundleResult result_of(const std::string& text);

}  // namespace pantin::player
