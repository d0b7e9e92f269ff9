#pragma once
// What is to be done of a sweep, and what is done.
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "player/progress.hpp"
#include "player/sweep/best.hpp"
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
  /// `best`: of a search, else null. Throws UsageError where a file that the journal's cases read was changed since.
  Course(const Cases& cases, Journal& journal, Best* best);
  /// A case that has no row; none: until another is kept, or for good.
  std::optional<CaseOrder> next();
  /// Throws Error where a file was changed since another case read it, UsageError where a search has nothing to search for.
  void keep(CaseRow row);

 private:
  std::optional<std::uint64_t> next_number();
  void note_file(const std::string& path, const std::string& hash);

  const Cases& cases_;
  Journal& journal_;
  Best* best_;
  std::map<std::string, std::string> files_;  ///< that the cases read, and a hash of each
  std::set<std::string> kept_;                ///< of them, those that the journal has
  CaseProgress progress_;
  std::uint64_t next_ = 0, bad_;
};

}  // namespace pantin::player
