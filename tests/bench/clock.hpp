#pragma once
#include <time.h>

namespace pantin {

/// [s] Of one thread the time of the processor, which others on the machine do not lengthen; of more that of the clock.
inline double now(int threads = 1) {
  timespec time;
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// [s] Of the processor, of all threads of the process together.
inline double processor_time() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace pantin
