#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

namespace pantin {

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

void Workers::share(std::size_t tasks, void (*call)(void*, std::size_t, int), void* f) {
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tasks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const int worker = tbb::this_task_arena::current_thread_index();
          for (std::size_t task = range.begin(); task != range.end(); task++) call(f, task, worker);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace pantin
