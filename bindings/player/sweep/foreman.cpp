#include "player/sweep/foreman.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>

#include "player/interrupt.hpp"
#include "player/sweep/pipe_text.hpp"
#include "player/sweep/workers.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

Foreman::Foreman(const std::function<std::string(const std::string&)>& work,
                 const std::function<std::string(const std::string&, const std::string&)>& died) {
  std::array<int, 2> there{}, back{};
  require(pipe2(there.data(), O_CLOEXEC) == 0, "sweep: no pipe: ", std::strerror(errno));
  require(pipe2(back.data(), O_CLOEXEC) == 0, "sweep: no pipe: ", std::strerror(errno));
  process_ = fork();
  require(process_ >= 0, "sweep: no process: ", std::strerror(errno));
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const int number : {SIGINT, SIGHUP}) std::signal(number, SIG_IGN);
    std::signal(SIGTERM, SIG_DFL);
    close(there[1]);
    close(back[0]);
    Workers one(1, work);
    one.run(
        [&]() -> std::optional<std::string> {
          std::string piece;
          return read_text(there[0], piece) ? std::optional(piece) : std::nullopt;
        },
        [&](const std::string& result) { write_text(back[1], result); },
        [&](const std::string& piece, const std::string& how) { write_text(back[1], died(piece, how)); });
    _exit(0);
  }
  close(there[0]);
  close(back[1]);
  to_ = there[1];
  from_ = back[0];
}

Foreman::~Foreman() {
  close(to_);
  close(from_);
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {}
}

std::string Foreman::result_of(const std::string& piece) const {
  std::string result;
  bool is_there = write_text(to_, piece);
  for (pollfd end{from_, POLLIN, 0}; is_there && poll(&end, 1, 200) <= 0;)
    if (Interrupt::asked()) throw Interrupted("stopped");
  is_there = is_there && read_text(from_, result);
  for (int wait = 0; !is_there && wait < 10; wait++) {  // what ends it may be what ends this one
    if (Interrupt::asked()) throw Interrupted("stopped");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  require(is_there, "sweep: the process that runs cases is gone");
  return result;
}

}  // namespace pantin::player
