#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace pantin::player {

/// Tells when files were written: by their times and sizes, so that editors that write another file and give it the name
/// are seen, too.
class FileWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// From now on this file counts, as it is at present.
  void add(const std::string& path);
  /// The others count no longer.
  void keep_only(const std::map<std::string, std::string>& files);
  /// Whether one was written since it was told last, and none has changed for a moment: what is being written is left
  /// alone. Looks at the disk 20 times a second at most.
  bool changed(Clock::time_point now);

 private:
  struct Stamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;
    bool there = false;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  struct File {
    Stamp told, seen;
  };
  static Stamp stamp_of(const std::filesystem::path& path);

  std::map<std::filesystem::path, File> files_;
  Clock::time_point next_{};
};

}  // namespace pantin::player
