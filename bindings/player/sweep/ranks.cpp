#include "player/sweep/ranks.hpp"

#ifdef PANTIN_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
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

constexpr int piece_tag = 1, end_tag = 2, result_tag = 3;

/// Waits without using a processor, which a case may need: the longer it has waited, the less often it looks.
bool wait_for_message(int from, MPI_Status& status) {
  using namespace std::chrono_literals;
  std::chrono::microseconds pause = 20us;
  for (int there = 0; !Interrupt::asked();
       std::this_thread::sleep_for(pause), pause = std::min<std::chrono::microseconds>(2 * pause, 1ms)) {
    MPI_Iprobe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there) return true;
  }
  return false;
}

void send(const std::string& text, int rank, int tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
}

/// The text of a message that has come.
std::string receive(const MPI_Status& status) {
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), ' ');
  MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

}  // namespace

Ranks::Ranks() {
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
  MPI_Finalize();
}

void Ranks::dismiss() {
  for (int rank = 1; rank < count_ && !dismissed_; rank++)
    MPI_Send(nullptr, 0, MPI_CHAR, rank, end_tag, MPI_COMM_WORLD);
  dismissed_ = true;
}

bool Ranks::hand_out(const std::function<std::optional<std::string>()>& next,
                     const std::function<void(const std::string&)>& done) {
  std::vector<int> pieces(static_cast<std::size_t>(count_));  // that each rank has
  int busy = 0;
  const auto give = [&] {
    for (int most = 1; most <= 2; most++)  // so that none waits for its next
      for (int rank = 1; rank < count_; rank++) {
        int& has = pieces[static_cast<std::size_t>(rank)];
        if (has >= most) continue;
        const auto piece = next();
        if (!piece) return;
        send(*piece, rank, piece_tag);
        has++;
        busy++;
      }
  };
  for (give(); busy > 0; give()) {
    MPI_Status status;
    if (!wait_for_message(MPI_ANY_SOURCE, status)) return false;
    const std::string result = receive(status);
    busy--;
    pieces[static_cast<std::size_t>(status.MPI_SOURCE)]--;
    done(result);
  }
  dismiss();
  return true;
}

void Ranks::serve(const std::function<std::string(const std::string&)>& work) {
  for (MPI_Status status; wait_for_message(0, status) && status.MPI_TAG == piece_tag;)
    send(work(receive(status)), 0, result_tag);
}

#else

Ranks::Ranks() {
  throw UsageError(text("mpirun started ", ranks_started(),
                        " processes, but this program was built without MPI. Type: apt-get install -y openmpi-bin "
                        "libopenmpi-dev, and build it again from nothing"));
}

Ranks::~Ranks() = default;
void Ranks::dismiss() { dismissed_ = true; }
bool Ranks::hand_out(const std::function<std::optional<std::string>()>&,
                     const std::function<void(const std::string&)>&) {
  return count_ > 0;
}
void Ranks::serve(const std::function<std::string(const std::string&)>&) {}

#endif

}  // namespace pantin::player
