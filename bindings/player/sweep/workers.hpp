#pragma once
// Processes that do pieces of work, each told as a text: one that dies takes no other with it.
#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pantin::player {

/// Forked, so this process must have no thread but this one.
class Workers {
 public:
  /// `work` is done in them, and its text comes back.
  Workers(int count, std::function<std::string(const std::string&)> work);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Asks `next` for work until it has none though all is done, and tells `done` of each piece's result as it ends; or `died`,
  /// of the piece and how its process ended. False where Ctrl-C came before all was done. Throws Error where there can be no processes.
  bool run(const std::function<std::optional<std::string>()>& next,
           const std::function<void(const std::string& result)>& done,
           const std::function<void(const std::string& piece, const std::string& how)>& died);

 private:
  struct Worker {
    pid_t process = -1;
    int to = -1, from = -1;
    std::optional<std::string> busy;  ///< with this piece
  };
  void start(Worker& worker);
  std::string end(Worker& worker);
  [[noreturn]] void serve(int from, int to);

  std::function<std::string(const std::string&)> work_;
  std::vector<Worker> workers_;
};

}  // namespace pantin::player
