#include "player/sweep/ranks.hpp"

#ifdef PANTIN_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
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

#ifdef PANTIN_MPI

namespace {

constexpr int piece_tag = 1, end_tag = 2, result_tag = 3, part_tag = 4;  // the rest of a text follows

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

bool Ranks::hand_out(const std::function<std::optional<std::string>()>& next,
                     const std::function<void(const std::string&)>& done, const std::function<bool()>& ahead) {
  std::vector<int> pieces(static_cast<std::size_t>(count_));  // that each rank has
  int busy = 0;
  const auto give = [&] {
    for (int most = 1; most <= (ahead() ? 2 : 1); most++)
      for (int rank = 1; rank < count_; rank++) {
        int& has = pieces[static_cast<std::size_t>(rank)];
        if (has >= most) continue;
        const auto piece = next();
        if (!piece) return;
        post_->send(*piece, rank, piece_tag);
        has++;
        busy++;
      }
  };
  for (give(); busy > 0; give()) {
    MPI_Status status;
    if (!wait_for_message(MPI_ANY_SOURCE, status, ahead() ? when_none_waits : soon)) return false;
    const std::string result = receive(status);
    busy--;
    pieces[static_cast<std::size_t>(status.MPI_SOURCE)]--;
    done(result);
  }
  dismiss();
  return true;
}

void Ranks::serve(const std::function<std::string(const std::string&)>& work) {
  for (MPI_Status status; wait_for_message(0, status) && status.MPI_TAG != end_tag;) try {
      post_->send(work(receive(status)), 0, result_tag);
    } catch (const Interrupted&) { throw; } catch (const Error& error) {  // the first rank would wait for it for ever
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
