#include "player/sweep/ranks.hpp"

#ifdef PANTIN_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <list>
#include <thread>
#include <vector>

#include "player/interrupt.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

int ranks_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE"})
    if (const char* value = std::getenv(name)) return std::max(1, std::atoi(value));
  const char* const tasks = std::getenv("SLURM_STEP_NUM_TASKS");  // of srun, not of a script that sbatch runs
  const int started = tasks ? std::max(1, std::atoi(tasks)) : 1;
  if (started > 1 && !std::getenv("PMIX_RANK"))
    throw UsageError(text("srun started ", started,
                          " processes that do not know of each other, and each would run all cases: srun --mpi=pmix"));
  return started;
}

bool is_later_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
    if (const char* value = std::getenv(name)) return std::atoi(value) > 0;
  return false;
}

#ifdef PANTIN_MPI

namespace {

constexpr int piece_tag = 1, end_tag = 2, result_tag = 3,
              part_tag = 4,  // the rest of a text follows
    drop_tag = 5;            // how many pieces the rank has got, the last of which another does

using namespace std::chrono_literals;
constexpr std::chrono::microseconds soon = 2ms, when_none_waits = 20ms;

/// Waits without using a processor, which a case may need: the longer it has waited, the less often it looks.
bool wait_for_message(int from, MPI_Status& status, std::chrono::microseconds longest = soon) {
  std::chrono::microseconds pause = 20us;
  for (int there = 0; !Interrupt::asked(); std::this_thread::sleep_for(pause), pause = std::min(2 * pause, longest)) {
    MPI_Iprobe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there) return true;
  }
  return false;
}

/// The text whose first part has come.
std::string receive(MPI_Status status) {
  std::string text;
  while (true) {
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    const std::size_t from = text.size();
    text.resize(from + static_cast<std::size_t>(size));
    MPI_Recv(text.data() + from, size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (status.MPI_TAG != part_tag) return text;
    MPI_Probe(status.MPI_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &status);
  }
}

}  // namespace

/// Texts on their way. MPI_Send would wait with most of them, and use a processor, until the other side looks.
struct Ranks::Post {
  struct Letter {
    std::string text;
    std::vector<MPI_Request> parts;
    bool has_come() {
      int all = 0;
      MPI_Testall(static_cast<int>(parts.size()), parts.data(), &all, MPI_STATUSES_IGNORE);
      return all != 0;
    }
  };
  std::list<Letter> letters;

  /// In parts so short that MPI needs nothing more of this side.
  void send(const std::string& text, int rank, int tag) {
    constexpr std::size_t most = 2048;
    letters.remove_if([](Letter& letter) { return letter.has_come(); });
    letters.push_back({text, {}});
    Letter& letter = letters.back();
    for (std::size_t from = 0; from == 0 || from < text.size(); from += most) {
      const std::size_t size = std::min(most, text.size() - from);
      MPI_Isend(letter.text.data() + from, static_cast<int>(size), MPI_CHAR, rank,
                from + size < text.size() ? part_tag : tag, MPI_COMM_WORLD, &letter.parts.emplace_back());
    }
  }
  /// What nobody takes any more.
  void drop() {
    for (Letter& letter : letters)
      if (!letter.has_come())
        for (MPI_Request& part : letter.parts)
          if (part != MPI_REQUEST_NULL) MPI_Request_free(&part);
  }
};

Ranks::Ranks() : post_(std::make_unique<Post>()) {
  const int started = ranks_started();  // MPI changes the environment
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  if (count_ > 1) return;
  MPI_Finalize();
  throw UsageError(text(started,
                        " processes were started together, and MPI knows of this one alone: start them by the mpirun "
                        "of the MPI that this program was built with, or by srun --mpi=pmix"));
}

Ranks::~Ranks() {
  if (first()) dismiss();
  post_->drop();
  MPI_Finalize();
}

void Ranks::dismiss() {
  for (int rank = 1; rank < count_ && !dismissed_; rank++)
    MPI_Send(nullptr, 0, MPI_CHAR, rank, end_tag, MPI_COMM_WORLD);
  dismissed_ = true;
}

/// What the ranks are given, by the first.
class Ranks::Shares {
 public:
  Shares(Post& post, int count) : post_(post), ranks_(static_cast<std::size_t>(count)) {}

  /// As many pieces as each rank may have.
  void give(const std::function<std::optional<std::string>()>& next, std::size_t most) {
    for (std::size_t has = 0; has < most; has++)
      for (std::size_t rank = 1; rank < ranks_.size(); rank++) {
        if (ranks_[rank].pieces.size() > has) continue;
        if (const auto piece = next())
          send(std::make_shared<Piece>(Piece{*piece}), rank);
        else if (has == 0)
          take_over(rank);
        else
          return;
      }
  }
  bool all_are_idle() const {
    return std::ranges::all_of(ranks_, [](const Rank& rank) { return rank.pieces.empty(); });
  }
  /// Whether the piece that a rank has sent the result of was not done before.
  bool is_new(std::size_t rank, const std::string& result) {
    const std::shared_ptr<Piece> piece = ranks_[rank].pieces.front();
    ranks_[rank].pieces.pop_front();
    return !result.empty() && !std::exchange(piece->done, true);
  }

 private:
  struct Piece {
    std::string text;
    bool done = false;
    bool taken_over = false;
  };
  struct Rank {
    std::deque<std::shared_ptr<Piece>> pieces;
    int sent = 0;
  };
  Post& post_;
  std::vector<Rank> ranks_;

  void send(std::shared_ptr<Piece> piece, std::size_t rank) {
    post_.send(piece->text, static_cast<int>(rank), piece_tag);
    ranks_[rank].pieces.push_back(std::move(piece));
    ranks_[rank].sent++;
  }
  /// A piece that waits for the one before it, of which nobody knows how long it takes.
  void take_over(std::size_t idle) {
    const auto waits = [](const Rank& rank) { return rank.pieces.size() > 1 && !rank.pieces.back()->taken_over; };
    const auto from = std::ranges::find_if(ranks_, waits);
    if (from == ranks_.end()) return;
    from->pieces.back()->taken_over = true;
    post_.send(std::to_string(from->sent), static_cast<int>(from - ranks_.begin()), drop_tag);
    send(from->pieces.back(), idle);
  }
};

bool Ranks::hand_out(const std::function<std::optional<std::string>()>& next,
                     const std::function<void(const std::string&)>& done, const std::function<bool()>& ahead) {
  Shares shares(*post_, count_);
  for (shares.give(next, ahead() ? 2 : 1); !shares.all_are_idle(); shares.give(next, ahead() ? 2 : 1)) {
    MPI_Status status;
    if (!wait_for_message(MPI_ANY_SOURCE, status, ahead() ? when_none_waits : soon)) return false;
    const std::string result = receive(status);
    if (shares.is_new(static_cast<std::size_t>(status.MPI_SOURCE), result)) done(result);
  }
  dismiss();
  return true;
}

void Ranks::serve(const std::function<std::string(const std::string&)>& work) {
  int got = 0, dropped = 0;
  const auto look_for_dropped = [&] {
    MPI_Status status;
    int there = 0;
    while (MPI_Iprobe(0, drop_tag, MPI_COMM_WORLD, &there, &status), there)
      dropped = std::atoi(receive(status).c_str());
  };
  for (MPI_Status status; wait_for_message(0, status) && status.MPI_TAG != end_tag;) try {
      if (status.MPI_TAG == drop_tag) {
        look_for_dropped();
        continue;
      }
      const std::string piece = receive(status);
      got++;
      look_for_dropped();
      post_->send(dropped == got ? "" : work(piece), 0, result_tag);
    } catch (const Interrupted&) { return; } catch (const Error& error) {  // the first rank would wait for it for ever
      std::fprintf(stderr, "pantin: %s: the same command goes on\n", error.what());
      MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    }
}

#else

struct Ranks::Post {};

Ranks::Ranks() {
  throw UsageError(text("mpirun started ", ranks_started(),
                        " processes, but this program was built without MPI. Type: apt-get install -y openmpi-bin "
                        "libopenmpi-dev, and build it again from nothing"));
}

Ranks::~Ranks() = default;
void Ranks::dismiss() { dismissed_ = true; }
bool Ranks::hand_out(const std::function<std::optional<std::string>()>&, const std::function<void(const std::string&)>&,
                     const std::function<bool()>&) {
  return count_ > 0;
}
void Ranks::serve(const std::function<std::string(const std::string&)>&) {}

#endif

}  // namespace pantin::player
