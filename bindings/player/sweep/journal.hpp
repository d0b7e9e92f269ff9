#pragma once
// The rows of a sweep that are finished, beside its table: what was stopped, at any moment, goes on with the rest.
#include <map>
#include <string>

#include "player/sweep/row.hpp"

namespace pantin::player {

class Journal {
 public:
  /// Opens or begins a file; one that is finished begins anew. `sweep` is a line of text that says which sweep it is of: a file
  /// of another one, a line that this program has not written so, or another process that writes to it throw UsageError. A
  /// last line that was cut off is left out. With `retry` rows that failed are left out, those of a finished one too; where
  /// there is no file that throws UsageError.
  Journal(std::string path, const std::string& sweep, bool retry = false);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// By their numbers.
  const std::map<std::uint64_t, CaseRow>& rows() const { return rows_; }
  /// Keeps a row. Throws Error where it cannot be written.
  void add(CaseRow row);
  /// That rows, those left out too, say were read, with a hash of each; a file may come more than once.
  const Cells& files() const { return files_; }
  /// All is in the table: the file goes.
  void remove();
  /// All is in the table, but the file stays.
  void finish();

 private:
  void read(const std::string& sweep, bool retry);
  void read_row(const std::string& line);
  void cut_off_at(std::size_t size);
  void write_line(const std::string& content);

  std::string path_;
  int file_ = -1;
  std::map<std::uint64_t, CaseRow> rows_;
  Cells files_;
};

/// As one line of text, and back. Throws Error.
std::string line_of(const CaseRow& row);
CaseRow row_of(const std::string& line);

/// A case that is to be run: its number, and what is set. As a text, and back.
struct CaseOrder {
  std::uint64_t number = 0;
  Cells set;
};
std::string text_of(const CaseOrder& order);
CaseOrder order_of(const std::string& text);

}  // namespace pantin::player
