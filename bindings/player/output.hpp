#pragma once
#include <string>

#include "player/unfinished.hpp"

namespace pantin::player {

/// "pantin-0001" and that ending, or the first number after it of which there is no file.
std::string free_name(const std::string& ending);

/// What a path leads to once links are followed, those to what is not there yet as well.
std::string followed(const std::string& path);

/// Whether two paths lead to one file, which need not be there yet.
bool same_file(const std::string& a, const std::string& b);

/// Throws UsageError where a file that is to be written is one that is read.
void keep_apart(const std::string& written, const std::string& read);

/// A file to be written: grows under a temporary name beside its own, takes its own when it is complete, and is gone if
/// it never is. A device or pipe is written to as it is.
class Output {
 public:
  /// Makes the temporary file, so that a place that cannot be written to, or where a script is, is known before a run:
  /// throws UsageError.
  explicit Output(std::string path);
  ~Output();
  Output(Output&& other) noexcept;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  Output& operator=(Output&&) = delete;

  const std::string& path() const { return path_; }
  /// Where to write to; it ends as `path` does.
  const std::string& temporary() const { return temporary_; }
  /// Writes a text as the whole of it. Throws Error.
  void write(const std::string& text) const;
  /// It will never be complete.
  void drop();
  /// A message about the temporary file, as one about the file that it is to be.
  std::string in_own_name(std::string message) const;
  /// It is complete: flushed to its disk, then it takes its name. Throws Error.
  void keep();

 private:
  std::string path_;
  std::string target_;     ///< what `path` leads to
  std::string temporary_;  ///< empty: nothing to clean up
  Unfinished unfinished_;
};

}  // namespace pantin::player
