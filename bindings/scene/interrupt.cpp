#include "scene/interrupt.hpp"

#include <time.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace pantin {
namespace {

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();  // [ns]
constexpr std::int64_t moment = 200'000'000;                              // [ns] to end in after an interrupt

/// [ns] of the steady clock: when scripts are to have ended.
std::atomic<std::int64_t> last_call{never};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal's handler writes it");

std::int64_t now_ns() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1'000'000'000 + t.tv_nsec;
}

}  // namespace

void interrupt_scripts() noexcept { last_call = now_ns() + moment; }
bool scripts_interrupted() noexcept { return last_call != never; }
bool scripts_must_end() noexcept { return now_ns() >= last_call; }
void allow_scripts() noexcept { last_call = never; }

}  // namespace pantin
