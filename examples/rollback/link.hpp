#pragma once
// Packets over UDP to another process on this machine, late and lossy as over a bad network.
#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "base/random.hpp"

namespace rollback {

struct BadNetwork {
  double delay = 0.05;  ///< [s] at least, of each packet that is sent; up to twice as much
  double loss = 0.1;    ///< 0 … 1 of the packets
};

class Link {
 public:
  /// Throws std::runtime_error where the port is taken.
  Link(std::uint16_t own_port, std::uint16_t other_port, const BadNetwork& network);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  void send(std::string packet);
  /// Packets that came; sends what is due by now.
  std::vector<std::string> receive();

 private:
  using Clock = std::chrono::steady_clock;
  struct Late {
    Clock::time_point due;
    std::string packet;
  };

  int socket_ = -1;
  BadNetwork network_;
  pantin::Random random_;
  std::deque<Late> late_;
};

}  // namespace rollback
