#include "link.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace rollback {
namespace {

sockaddr_in address(std::uint16_t port) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(port);
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return at;
}

}  // namespace

Link::Link(std::uint16_t own_port, std::uint16_t other_port, const BadNetwork& network)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)), network_(network), random_{own_port, 0} {
  const sockaddr_in own = address(own_port), other = address(other_port);
  const auto* at = reinterpret_cast<const sockaddr*>(&own);
  const auto* to = reinterpret_cast<const sockaddr*>(&other);
  if (socket_ < 0 || bind(socket_, at, sizeof own) != 0 || connect(socket_, to, sizeof other) != 0)
    throw std::runtime_error(std::string("cannot use the port: ") + std::strerror(errno));
}

Link::~Link() {
  if (socket_ >= 0) close(socket_);
}

void Link::send(std::string packet) {
  if (random_.uniform() < network_.loss) return;
  const std::chrono::duration<double> delay(network_.delay * (1.0 + random_.uniform()));
  late_.push_back({Clock::now() + std::chrono::duration_cast<Clock::duration>(delay), std::move(packet)});
}

std::vector<std::string> Link::receive() {
  for (; !late_.empty() && late_.front().due <= Clock::now(); late_.pop_front()) {
    const std::string& packet = late_.front().packet;
    // The other may not be there yet: what is lost is sent again.
    (void)!::send(socket_, packet.data(), packet.size(), 0);
  }
  std::vector<std::string> came;
  char buffer[2048];
  for (;;) {
    const ssize_t size = recv(socket_, buffer, sizeof buffer, 0);
    if (size < 0 && errno == ECONNREFUSED) continue;
    if (size < 0) return came;
    came.emplace_back(buffer, static_cast<std::size_t>(size));
  }
}

}  // namespace rollback
