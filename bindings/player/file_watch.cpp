#include "player/file_watch.hpp"

#include <system_error>
#include <utility>

namespace pantin::player {

namespace {
constexpr std::chrono::milliseconds interval{50};
}

FileWatch::Stamp FileWatch::stamp_of(const std::filesystem::path& path) {
  std::error_code error;
  Stamp stamp;
  stamp.time = std::filesystem::last_write_time(path, error);
  if (!error) stamp.size = std::filesystem::file_size(path, error);
  stamp.there = !error;
  return error ? Stamp{} : stamp;
}

void FileWatch::add(const std::string& path) {
  const Stamp now = stamp_of(path);
  files_[path] = {now, now};
}

void FileWatch::keep_only(const std::map<std::string, std::string>& files) {
  std::erase_if(files_, [&](const auto& watched) { return !files.contains(watched.first); });
}

bool FileWatch::changed(Clock::time_point now) {
  if (now < next_) return false;
  next_ = now + interval;
  bool written = false, still = true;
  for (auto& [path, file] : files_) {
    const Stamp before = std::exchange(file.seen, stamp_of(path));
    still = still && file.seen == before && file.seen.there;
    written = written || file.seen != file.told;
  }
  if (!written || !still) return false;
  for (auto& [path, file] : files_) file.told = file.seen;
  return true;
}

}  // namespace pantin::player
