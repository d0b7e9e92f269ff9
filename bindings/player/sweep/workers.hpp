#pragma once
// Processes that do numbered pieces of work: one that dies takes no other with it.
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pantin::player {

/// Forked, so this process must have no thread but this one.
class Workers {
 public:
  /// `work` is done in them, and its text comes back.
  Workers(int count, std::function<std::string(std::uint64_t)> work);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Asks `next` for work until it has none, and tells `done` of each as it ends; or `died`, with how its process ended.
  /// False where Ctrl-C came before all was done. Throws Error where there can be no processes.
  bool run(const std::function<std::optional<std::uint64_t>()>& next,
           const std::function<void(std::uint64_t, const std::string&)>& done,
           const std::function<void(std::uint64_t, const std::string&)>& died);

 private:
  struct Worker {
    pid_t process = -1;
    int to = -1, from = -1;
    std::optional<std::uint64_t> busy;
  };
  void start(Worker& worker);
  std::string end(Worker& worker);
  [[noreturn]] void serve(int from, int to);

  std::function<std::string(std::uint64_t)> work_;
  std::vector<Worker> workers_;
};

}  // namespace pantin::player
