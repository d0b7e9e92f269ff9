#include "player/interrupt.hpp"

#include <csignal>

#include "player/unfinished.hpp"
#include "scene/interrupt.hpp"

namespace pantin::player {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void die(int number) {
  Unfinished::remove_all();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void note(int number) {
  if (interrupted == 0) {
    interrupted = 1;
    return interrupt_scripts();
  }
  die(number);
}

}  // namespace

Interrupt::Interrupt() {
  interrupted = 0;
  allow_scripts();
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGABRT, die);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGABRT, SIG_DFL);
  interrupted = 0;
  allow_scripts();
}

bool Interrupt::asked() { return interrupted != 0; }

}  // namespace pantin::player
