#pragma once
// The processes that mpirun or Slurm started: the first hands out numbered pieces of work, the others do them.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace pantin::player {

/// How many processes were started together, by what their environment says; 1: this one alone.
int ranks_started();

/// All of them together, from first to last. Throws UsageError where this program was built without MPI.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool first() const { return rank_ == 0; }
  /// Of the first: asks `next` for work until it has none, and tells `done` of each as it ends. False where Ctrl-C came before
  /// all was done. The others are then told to end.
  bool hand_out(const std::function<std::optional<std::uint64_t>()>& next,
                const std::function<void(std::uint64_t, const std::string&)>& done);
  /// Of the others: until they are told to end.
  void serve(const std::function<std::string(std::uint64_t)>& work);
  /// Of the first, where it goes no farther: the others end, too.
  void dismiss();

 private:
  int rank_ = 0, count_ = 1;
  bool dismissed_ = false;
};

}  // namespace pantin::player
