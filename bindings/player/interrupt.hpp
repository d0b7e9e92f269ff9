#pragma once

namespace pantin::player {

/// While it lives, Ctrl-C and SIGTERM ask for a clean end instead of killing the program, and stop a script that does not
/// come back; a second one removes what is half written, and kills.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool asked();
};

}  // namespace pantin::player
