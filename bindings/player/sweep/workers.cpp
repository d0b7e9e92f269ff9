#include "player/sweep/workers.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "player/interrupt.hpp"
#include "player/sweep/pipe_text.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return text("its process ended with exit code ", WEXITSTATUS(status));
  return text("its process was ended by signal ", WTERMSIG(status), " (", strsignal(WTERMSIG(status)), ")");
}

/// Neither the journal, nor the other ends of pipes, which else would never be seen to end, nor what a person types.
void close_all_but(int from, int to) {
  const unsigned ends[] = {static_cast<unsigned>(std::min(from, to)), static_cast<unsigned>(std::max(from, to))};
  unsigned first = STDERR_FILENO + 1;
  for (const unsigned kept : ends) {
    if (kept > first) close_range(first, kept - 1, 0);
    first = kept + 1;
  }
  close_range(first, ~0U, 0);
  if (const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC); nowhere >= 0)
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, standard);
}

}  // namespace

Workers::Workers(int count, std::function<std::string(const std::string&)> work)
    : work_(std::move(work)), workers_(static_cast<std::size_t>(count)) {}

Workers::~Workers() {
  for (Worker& worker : workers_) {
    if (worker.process > 0) kill(worker.process, SIGKILL);
    end(worker);
  }
}

void Workers::serve(int from, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGHUP})
    std::signal(number, SIG_IGN);  // which the terminal sends to all: the first process ends this one
  std::signal(SIGTERM, SIG_DFL);
  close_all_but(from, to);
  for (std::string piece; read_text(from, piece);)
    if (!write_text(to, work_(piece))) break;
  _exit(0);
}

void Workers::start(Worker& worker) {
  std::array<int, 2> there{}, back{};
  require(pipe2(there.data(), O_CLOEXEC) == 0, "sweep: no pipe: ", std::strerror(errno));
  require(pipe2(back.data(), O_CLOEXEC) == 0, "sweep: no pipe: ", std::strerror(errno));
  worker.process = fork();
  require(worker.process >= 0, "sweep: no process: ", std::strerror(errno));
  if (worker.process == 0) serve(there[0], back[1]);
  close(there[0]);
  close(back[1]);
  worker.to = there[1];
  worker.from = back[0];
}

std::string Workers::end(Worker& worker) {
  if (worker.to >= 0) close(worker.to);
  if (worker.from >= 0) close(worker.from);
  int status = 0;
  if (worker.process > 0)
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {}
  worker = {};
  return how_it_ended(status);
}

bool Workers::run(const std::function<std::optional<std::string>()>& next,
                  const std::function<void(const std::string&)>& done,
                  const std::function<void(const std::string&, const std::string&)>& died) {
  std::size_t busy = 0;
  const auto give = [&] {
    for (Worker& worker : workers_) {
      if (worker.busy) continue;
      worker.busy = next();
      if (!worker.busy) return;
      if (worker.process < 0) start(worker);
      busy++;
      write_text(worker.to, *worker.busy);  // where it is dead, the end of its pipe tells
    }
  };
  for (give(); busy > 0; give()) {
    if (Interrupt::asked()) return false;
    std::vector<pollfd> ends;
    for (const Worker& worker : workers_) ends.push_back({worker.busy ? worker.from : -1, POLLIN, 0});
    if (poll(ends.data(), ends.size(), 200) <= 0) continue;
    for (std::size_t i = 0; i < ends.size(); i++) {
      if (ends[i].revents == 0) continue;
      Worker& worker = workers_[i];
      const std::string piece = worker.busy.value();
      std::string result;
      const bool whole = read_text(worker.from, result);
      worker.busy.reset();
      busy--;
      if (whole)
        done(result);
      else
        died(piece, end(worker));
    }
    if (Interrupt::asked()) return false;
  }
  return !Interrupt::asked();
}

}  // namespace pantin::player
