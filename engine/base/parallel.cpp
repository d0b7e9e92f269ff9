#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

// oneTBB is not built for the thread sanitizer, which must be told what waits for what, and to pass over its own tasks; nor are
// the driver that draws and X11.
#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
extern "C" const char* __tsan_default_suppressions() {
  return "race_top:oneapi/tbb\nrace_top:base/parallel.cpp\nrace_top:std::__atomic_base<int>::\n"
         "race:swrast_dri.so\nrace:libgallium\nmutex:libX11.so\n";
}
#endif

namespace pantin {

namespace {

struct Moment {
  void is_before_those_that_wait() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(this);
#endif
  }
  void wait_is_over() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(this);
#endif
  }
};

}  // namespace

struct Workers::Arena {
  explicit Arena(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)), arena(threads) {}
  tbb::global_control limit;
  tbb::task_arena arena;
};

Workers::Workers(int threads) : count_(threads) {
  if (threads == 0) count_ = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Workers::~Workers() = default;
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;

void Workers::start() {
  using namespace std::chrono_literals;
  const auto tasks = static_cast<std::size_t>(count_);
  std::atomic<std::size_t> begun = 0;
  const auto end = std::chrono::steady_clock::now() + 5s;  // a system that starts no more threads
  run(tasks, [&](std::size_t, int) {
    begun++;
    while (begun < tasks && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(100us);
  });
}

void Workers::share(std::size_t tasks, void (*call)(void*, std::size_t, int), void* f) {
  Moment start, end;
  start.is_before_those_that_wait();
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tasks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          start.wait_is_over();
          const int worker = tbb::this_task_arena::current_thread_index();
          for (std::size_t task = range.begin(); task != range.end(); task++) call(f, task, worker);
          end.is_before_those_that_wait();
        },
        tbb::simple_partitioner());
  });
  end.wait_is_over();
}

}  // namespace pantin
