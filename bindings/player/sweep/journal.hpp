#pragma once
// The rows of a sweep that are finished, beside its table: what was stopped, at any moment, goes on with the rest, and what is done
// is not done again.
#include <functional>
#include <map>
#include <set>
#include <string>

#include "player/sweep/row.hpp"

namespace pantin::player {

struct JournalWish {
  bool retry = false;      ///< rows that failed are left out, those of a finished sweep too
  bool overwrite = false;  ///< a table that is there, and a finished journal, may be lost
};

class Journal {
 public:
  /// Opens or begins the file of a table. `sweep` is a line of text that says which sweep it is of. A last line that was cut
  /// off is left out. Throws UsageError for a file of another sweep, a line that this program has not written so, another
  /// process that writes to it, a table or finished journal that would be lost without a wish, and none to retry.
  Journal(std::string table, const std::string& sweep, JournalWish wish = {});
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// By their numbers.
  const std::map<std::uint64_t, CaseRow>& rows() const { return rows_; }
  /// Keeps a row. Throws Error where it cannot be written.
  void add(CaseRow row);
  /// That rows, those left out too, say were read, with a hash of each; a file may come more than once.
  const Cells& files() const { return files_; }
  /// Throws UsageError where there is a table now that is not of this sweep, and may not be lost.
  void check_table() const;
  /// Keeps a table of that content, by which it is known from now on: all is in it.
  void finish(const std::function<void()>& keep_table, const std::string& content);
  /// No command is to go on with these rows.
  void remove();
  /// Whether all is in its table, or was when that was written.
  bool is_finished() const { return finished_; }

 private:
  void open();
  void begin(const std::string& sweep);
  void read(const std::string& content, const std::string& sweep);
  void read_line(const std::string& line);
  void cut_off_at(std::size_t size);
  void write_line(const std::string& content);

  std::string table_, path_;
  JournalWish wish_;
  int file_ = -1;
  bool finished_ = false;
  std::set<std::string> tables_;  ///< hashes of those that this sweep wrote
  std::map<std::uint64_t, CaseRow> rows_;
  Cells files_;
};

/// As one line of text, and back. Throws Error.
std::string line_of(const CaseRow& row);
CaseRow row_of(const std::string& line);

}  // namespace pantin::player
