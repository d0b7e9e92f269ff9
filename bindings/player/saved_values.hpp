#pragma once
#include <chrono>
#include <memory>
#include <string>

#include "scene/options.hpp"

namespace pantin::player {

/// What a scene keeps for the next time, in a file of the user's: `pantin/saved` in XDG_DATA_HOME, or in ~/.local/share.
class SavedFile {
 public:
  SavedFile() = default;
  /// Reads the file of a scene, by its path as recorded; one that is not there or cannot be understood is empty.
  explicit SavedFile(const std::string& scene);
  ~SavedFile();
  SavedFile(SavedFile&&) noexcept;
  SavedFile& operator=(SavedFile&&) noexcept;

  const std::shared_ptr<SavedValues>& values() const { return values_; }
  /// What is in the file: before the scene runs, what it begins with.
  const SavedValues& written() const { return written_; }
  /// Writes what has changed, at most once a second, and at the end.
  void keep();
  /// The same at once.
  void write();

 private:
  std::string path_;  ///< empty: it is not kept
  std::shared_ptr<SavedValues> values_ = std::make_shared<SavedValues>();
  SavedValues written_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace pantin::player
