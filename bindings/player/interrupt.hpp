#pragma once
#include <array>
#include <csignal>

namespace pantin::player {

/// While it lives, Ctrl-C, SIGTERM and a terminal that goes away ask for a clean end instead of killing the program, and stop
/// a script that does not come back; a second one, SIGQUIT, SIGXCPU and SIGABRT remove what is half written, and kill.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool asked();

 private:
  static constexpr std::array asks{SIGINT, SIGTERM, SIGHUP};
  static constexpr std::array kills{SIGABRT, SIGQUIT, SIGXCPU};
  std::array<struct sigaction, asks.size() + kills.size()> before_{};
};

}  // namespace pantin::player
