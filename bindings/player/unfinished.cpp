#include "player/unfinished.hpp"

#include <unistd.h>

#include <array>
#include <atomic>

namespace pantin::player {
namespace {

std::array<std::atomic<const char*>, 64> paths{};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal's handler reads them");

}  // namespace

struct Unfinished::Entry {
  explicit Entry(const std::string& p) : path(p) {
    for (auto& place : paths) {
      const char* none = nullptr;
      if (place.compare_exchange_strong(none, path.c_str())) return;
    }
  }
  ~Entry() {
    for (auto& place : paths) {
      const char* own = path.c_str();
      if (place.compare_exchange_strong(own, nullptr)) return;
    }
  }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  const std::string path;
};

Unfinished::Unfinished(const std::string& path) : entry_(std::make_shared<Entry>(path)) {}

void Unfinished::remove_all() noexcept {
  for (const auto& place : paths)
    if (const char* path = place) unlink(path);
}

}  // namespace pantin::player
