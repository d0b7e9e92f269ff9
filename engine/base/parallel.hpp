#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>

namespace pantin {

/// Threads that share out numbered tasks. What a task does must not depend on who does it, nor on what the other tasks
/// of the same run do: so the results are the same for any number of threads.
class Workers {
 public:
  /// With 1 thread everything runs in the caller's. 0: as many as the machine has processors.
  explicit Workers(int threads = 1);
  ~Workers();
  Workers(Workers&&) noexcept;
  Workers& operator=(Workers&&) noexcept;

  int count() const { return count_; }

  /// All threads are there from here on; as long as the caller's lives, none is started later for as many workers.
  void start();

  /// Calls f(task, worker) for every task < tasks, 0 <= worker < count(), each worker one task at a time. An exception of
  /// a task is thrown here.
  template <class F>
  void run(std::size_t tasks, F&& f) {
    if (count_ == 1 || tasks < 2) {
      for (std::size_t task = 0; task < tasks; task++) f(task, 0);
      return;
    }
    using Plain = std::remove_reference_t<F>;
    share(
        tasks, [](void* g, std::size_t task, int worker) { (*static_cast<Plain*>(g))(task, worker); },
        const_cast<void*>(static_cast<const void*>(&f)));
  }

 private:
  struct Arena;
  void share(std::size_t tasks, void (*call)(void*, std::size_t, int), void* f);

  int count_ = 1;
  std::unique_ptr<Arena> arena_;
};

}  // namespace pantin
