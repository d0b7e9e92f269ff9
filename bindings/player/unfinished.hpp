#pragma once
#include <memory>
#include <string>

namespace pantin::player {

/// A file that is being written: while this lives, a program that is killed by a signal it hears removes the file.
class Unfinished {
 public:
  Unfinished() = default;
  explicit Unfinished(const std::string& path);

  /// Removes all such files, the first 64 of them. For a signal's handler, before the end.
  static void remove_all() noexcept;

 private:
  struct Entry;
  std::shared_ptr<Entry> entry_;  // its text stays in its place when this moves
};

}  // namespace pantin::player
