#include "player/interrupt.hpp"

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
  auto* before = before_.begin();
  const auto hear = [&](int number, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(number, &action, before);
    if (number == SIGHUP && before->sa_handler == SIG_IGN) sigaction(number, before, nullptr);  // as nohup wants it
    before++;
  };
  for (const int number : asks) hear(number, note, SA_RESTART);
  for (const int number : kills) hear(number, die, 0);
}

Interrupt::~Interrupt() {
  const auto* before = before_.begin();
  for (const int number : asks) sigaction(number, before++, nullptr);
  for (const int number : kills) sigaction(number, before++, nullptr);
  interrupted = 0;
  allow_scripts();
}

bool Interrupt::asked() { return interrupted != 0; }

}  // namespace pantin::player
