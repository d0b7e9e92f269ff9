#pragma once
// What is to be done of a sweep, and what is done.
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/lanes.hpp"
#include "player/progress.hpp"
#include "player/sweep/best.hpp"
#include "player/sweep/bundle.hpp"
#include "player/sweep/cases.hpp"
#include "player/sweep/journal.hpp"

namespace pantin::player {

std::uint64_t failures(const Rows& rows);

class CaseProgress {
 public:
  CaseProgress(std::uint64_t done, std::uint64_t all) : before_(done), all_(all) {}
  void show(std::uint64_t done, std::uint64_t failed);

 private:
  std::uint64_t before_, all_;
  ProgressLine line_;
};

class Course {
 public:
  /// `best`: of a search, else null. `hands`: how many processes run cases. Throws UsageError where a file that the journal's
  /// cases read was changed since.
  Course(const Cases& cases, Journal& journal, Best* best, int hands);
  /// A bundle of cases that have no row, as a text; none: until others are kept, or for good.
  std::optional<std::string> next();
  /// Whether a case is so short that to wait for the next would take a part of it.
  bool is_quick() const { return !best_ && case_time_ < quick; }
  /// Of a bundle's result. Throws Error where a file was changed since another case read it, UsageError where a search has
  /// nothing to search for.
  void keep(const std::string& result);

 private:
  static constexpr double quick = 0.5;  // s

  std::optional<std::uint64_t> next_number();
  std::optional<CaseOrder> next_order();
  std::size_t bundle_size() const;
  void keep(CaseRow row);
  void note_file(const std::string& path, const std::string& hash);

  const Cases& cases_;
  Journal& journal_;
  Best* best_;
  std::uint64_t hands_;
  double case_time_ = infinity;               ///< of those that were kept last, s of the clock
  std::deque<CaseOrder> left_;                ///< of bundles, that are to be run yet
  std::deque<CaseOrder> suspects_;            ///< of bundles whose process ended: each is run by itself
  std::map<std::string, std::string> files_;  ///< that the cases read, and a hash of each
  std::set<std::string> kept_;                ///< of them, those that the journal has
  CaseProgress progress_;
  std::uint64_t next_ = 0, bad_;
};

}  // namespace pantin::player
