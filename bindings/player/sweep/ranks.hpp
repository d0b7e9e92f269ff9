#pragma once
// The processes that mpirun or Slurm started: the first hands out pieces of work as texts, the others do them.
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace pantin::player {

/// How many processes were started together, by what their environment says; 1: this one alone. Throws UsageError where they
/// cannot find each other.
int ranks_started();

/// Whether this is one of them, and not the first, by the same; false: that is not known.
bool is_later_rank();

/// All of them together, from first to last. Throws UsageError where this program was built without MPI.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool first() const { return rank_ == 0; }
  /// How many do pieces of work.
  int hands() const { return count_ - 1; }
  /// Of the first: asks `next` for work until it has none though all is done, and tells `done` of each result. `ahead`: whether
  /// one that has work gets another piece, so that it need not wait for it; where no other is left it goes to one that is
  /// idle. False where Ctrl-C came before all was done. The others are then told to end.
  bool hand_out(const std::function<std::optional<std::string>()>& next,
                const std::function<void(const std::string& result)>& done, const std::function<bool()>& ahead);
  /// Of the others: until they are told to end.
  void serve(const std::function<std::string(const std::string&)>& work);
  /// Of the first, where it goes no farther: the others end, too.
  void dismiss();

 private:
  struct Post;
  class Shares;

  std::unique_ptr<Post> post_;
  int rank_ = 0, count_ = 1;
  bool dismissed_ = false;
};

}  // namespace pantin::player
