#include "player/sweep/ranks.hpp"

#ifdef PANTIN_MPI
#include <mpi.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <thread>
#include <vector>

#include "player/interrupt.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

int ranks_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE"})
    if (const char* value = std::getenv(name)) return std::max(1, std::atoi(value));
  return 1;
}

#ifdef PANTIN_MPI

namespace {

constexpr int piece_tag = 1, end_tag = 2, result_tag = 3;

/// Waits without using a processor, which a case may need.
bool wait_for_message(int from, MPI_Status& status) {
  for (int there = 0; !Interrupt::asked(); std::this_thread::sleep_for(std::chrono::microseconds(50))) {
    MPI_Iprobe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there) return true;
  }
  return false;
}

}  // namespace

Ranks::Ranks() {
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
  if (first()) dismiss();
  MPI_Finalize();
}

void Ranks::dismiss() {
  for (int rank = 1; rank < count_ && !dismissed_; rank++)
    MPI_Send(nullptr, 0, MPI_UINT64_T, rank, end_tag, MPI_COMM_WORLD);
  dismissed_ = true;
}

bool Ranks::hand_out(const std::function<std::optional<std::uint64_t>()>& next,
                     const std::function<void(std::uint64_t, const std::string&)>& done) {
  std::vector<std::deque<std::uint64_t>> pieces(static_cast<std::size_t>(count_));
  int busy = 0;
  const auto give = [&](int rank) {
    const auto piece = next();
    if (!piece) return;
    pieces[static_cast<std::size_t>(rank)].push_back(*piece);
    MPI_Send(&*piece, 1, MPI_UINT64_T, rank, piece_tag, MPI_COMM_WORLD);
    busy++;
  };
  for (int ahead = 0; ahead < 2; ahead++)  // so that none waits for its next
    for (int rank = 1; rank < count_; rank++) give(rank);
  while (busy > 0) {
    MPI_Status status;
    if (!wait_for_message(MPI_ANY_SOURCE, status)) return false;
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string result(static_cast<std::size_t>(size), ' ');
    MPI_Recv(result.data(), size, MPI_CHAR, status.MPI_SOURCE, result_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    busy--;
    auto& waiting = pieces[static_cast<std::size_t>(status.MPI_SOURCE)];
    done(waiting.front(), result);
    waiting.pop_front();
    give(status.MPI_SOURCE);
  }
  dismiss();
  return true;
}

void Ranks::serve(const std::function<std::string(std::uint64_t)>& work) {
  for (MPI_Status status; wait_for_message(0, status) && status.MPI_TAG == piece_tag;) {
    std::uint64_t piece = 0;
    MPI_Recv(&piece, 1, MPI_UINT64_T, 0, piece_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const std::string result = work(piece);
    MPI_Send(result.data(), static_cast<int>(result.size()), MPI_CHAR, 0, result_tag, MPI_COMM_WORLD);
  }
}

#else

Ranks::Ranks() {
  throw UsageError(text("mpirun started ", ranks_started(),
                        " processes, but this program was built without MPI. Type: apt-get install -y openmpi-bin "
                        "libopenmpi-dev, and build it again from nothing"));
}

Ranks::~Ranks() = default;
void Ranks::dismiss() { dismissed_ = true; }
bool Ranks::hand_out(const std::function<std::optional<std::uint64_t>()>&,
                     const std::function<void(std::uint64_t, const std::string&)>&) {
  return count_ > 0;
}
void Ranks::serve(const std::function<std::string(std::uint64_t)>&) {}

#endif

}  // namespace pantin::player
