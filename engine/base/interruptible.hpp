#pragma once
// Long loops ask now and then whether whoever waits for them still does.
#include <atomic>
#include <cstddef>

#include "base/check.hpp"

namespace pantin {

/// The one who waited waits no more.
struct GivenUp : Error {
  GivenUp() : Error("it was given up") {}
};

/// Set by who waits, of this thread: true once it is given up; null: nobody ever will.
inline thread_local const std::atomic<bool>* given_up = nullptr;

inline bool is_given_up() { return given_up && *given_up; }
/// Throws GivenUp.
inline void stop_if_given_up() {
  if (is_given_up()) throw GivenUp();
}

/// Counts the steps of a loop.
class Interruptible {
 public:
  /// Throws GivenUp.
  void count(std::size_t steps = 1) {
    count_ += steps;
    if (count_ < often) return;
    count_ = 0;
    stop_if_given_up();
  }
  /// Counts what is done with many bytes at once.
  void count_bytes(std::size_t bytes) { count(1 + bytes / bytes_of_step); }

 private:
  static constexpr std::size_t often = 4096, bytes_of_step = 256;
  std::size_t count_ = 0;
};

}  // namespace pantin
