#include "player/interrupt.hpp"

#include <csignal>

namespace pantin::player {
namespace {
volatile std::sig_atomic_t interrupted = 0;
void note(int) { interrupted = 1; }
}  // namespace

Interrupt::Interrupt() {
  interrupted = 0;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::asked() { return interrupted != 0; }

}  // namespace pantin::player
