#pragma once
// A sweep that looks for the values that make one of its columns largest, or smallest.
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "player/sweep/cases.hpp"
#include "player/sweep/row.hpp"
#include "player/sweep/search.hpp"

namespace pantin::player {

struct Wanted {
  std::string column;  ///< of the table; empty: nothing is looked for
  bool least = false;  ///< else the largest
};

using Rows = std::map<std::uint64_t, CaseRow>;

/// Of each point that is asked, a case for each seed follows one another; what counts is their mean. A case that failed, or
/// whose cell is no finite number, makes its point worse than all others.
class Best {
 public:
  /// How many cases it has; `sample`: at most so many, 0: as many as are usual. Throws UsageError where the axes have no range
  /// to search, or a list.
  static std::uint64_t count(const std::vector<Axis>& axes, std::uint64_t sample);
  /// `cases` are unplaced.
  Best(Cases& cases, Wanted wanted);
  Best(const Best&) = delete;
  Best& operator=(const Best&) = delete;

  /// The next case to run that has no row, or none until another row is kept.
  std::optional<std::uint64_t> next(const Rows& rows);
  /// Call it after a row was kept. Throws UsageError where none of the first cases that did not fail has such a column, or
  /// one of them has no number there.
  void kept(const Rows& rows, std::uint64_t number);
  /// A sentence: what was best, and where. Empty: all failed.
  std::string told(const Rows& rows) const;

 private:
  std::vector<double> parts_of(const CubePoint& point, std::uint64_t seed) const;
  std::string key_of(const CubePoint& point) const;
  double value_of(const CaseRow& row) const;
  std::optional<double> mean(const Rows& rows, std::uint64_t point) const;
  void check(const Rows& rows);

  Cases& cases_;
  std::uint64_t seeds_;
  Wanted wanted_;
  std::vector<std::size_t> searched_;  ///< axes
  Search search_;
  std::deque<std::uint64_t> waiting_;  ///< cases of points that were asked
  std::uint64_t checked_ = 0;          ///< cases, up to the first that has such a column
  std::uint64_t without_ = 0;          ///< of them, that did not fail
  bool known_ = false;
};

}  // namespace pantin::player
