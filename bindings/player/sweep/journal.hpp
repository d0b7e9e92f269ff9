#pragma once
// The rows of a sweep that are finished, beside its table: what was stopped, at any moment, goes on with the rest.
#include <map>
#include <string>

#include "player/sweep/row.hpp"

namespace pantin::player {

class Journal {
 public:
  /// Opens or begins a file. `sweep` is a line of text that says which sweep it is of: a file of another one, a line that this
  /// program has not written so, or another process that writes to it throw UsageError. A last line that was cut off is
  /// left out.
  Journal(std::string path, const std::string& sweep);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// By their numbers.
  const std::map<std::uint64_t, CaseRow>& rows() const { return rows_; }
  /// Keeps a row. Throws Error where it cannot be written.
  void add(CaseRow row);
  /// All is in the table: the file goes.
  void remove();

 private:
  void read(const std::string& sweep);
  void write_line(const std::string& content);

  std::string path_;
  int file_ = -1;
  std::map<std::uint64_t, CaseRow> rows_;
};

/// As one line of text, and back. Throws Error.
std::string line_of(const CaseRow& row);
CaseRow row_of(const std::string& line);

}  // namespace pantin::player
