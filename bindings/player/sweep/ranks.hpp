#pragma once
// The processes that mpirun or Slurm started: the first hands out pieces of work as texts, the others do them.
#include <functional>
#include <optional>
#include <string>

namespace pantin::player {

/// How many processes were started together, by what their environment says; 1: this one alone. Throws UsageError where they
/// cannot find each other.
int ranks_started();

/// All of them together, from first to last. Throws UsageError where this program was built without MPI.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool first() const { return rank_ == 0; }
  /// Of the first: asks `next` for work until it has none though all is done, and tells `done` of each result. False where Ctrl-C came before
  /// all was done. The others are then told to end.
  bool hand_out(const std::function<std::optional<std::string>()>& next,
                const std::function<void(const std::string& result)>& done);
  /// Of the others: until they are told to end.
  void serve(const std::function<std::string(const std::string&)>& work);
  /// Of the first, where it goes no farther: the others end, too.
  void dismiss();

 private:
  int rank_ = 0, count_ = 1;
  bool dismissed_ = false;
};

}  // namespace pantin::player
