#pragma once

namespace pantin::player {

/// While it lives, Ctrl-C and SIGTERM ask for a clean end instead of killing the program; a second one kills.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool asked();
};

}  // namespace pantin::player
