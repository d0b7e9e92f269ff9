// Two processes that play one game over UDP, as examples/rollback does, never differ.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "support/process.hpp"
#include "support/sources.hpp"

namespace fs = std::filesystem;
using namespace pantin::support;

namespace {

Process::Options player(int number, int port, const std::string& frames) {
  const fs::path program = fs::path(pantin::sources::program()).parent_path() / "pantin_rollback";
  return {{program.string(), std::to_string(number), std::to_string(port + number), std::to_string(port + 1 - number),
           frames, "0.03", "0.2"},
          {},
          "",
          -1};
}

std::string after(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.substr(at + what.size(), 16);
}

}  // namespace

TEST_CASE("rollback: a packet that no player of this game can have sent changes nothing") {
  const int port = 20000 + getpid() % 20000;
  Process first(player(0, port, "300"));
  const int link = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in own{}, other{};
  own.sin_family = other.sin_family = AF_INET;
  own.sin_addr.s_addr = other.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  own.sin_port = htons(static_cast<std::uint16_t>(port + 1));
  other.sin_port = htons(static_cast<std::uint16_t>(port));
  REQUIRE(bind(link, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0);
  const auto size = recv(link, nullptr, 0, MSG_TRUNC);
  REQUIRE(size > 0);
  const std::string packet(static_cast<std::size_t>(size), '\xff');
  for (int i = 0; i < 100; i++)
    sendto(link, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&other), sizeof other);
  CHECK(!first.wait(1.0));
  close(link);
  Process second(player(1, port, "300"));
  REQUIRE(first.wait(300.0) == 0);
  REQUIRE(second.wait(300.0) == 0);
  CHECK(after(first.out(), "hash ") == after(second.out(), "hash "));
}

TEST_CASE("rollback: two players in two processes over a bad network predict, go back, and come to the same bits") {
  const int port = 20000 + getpid() % 20000;
  Process first(player(0, port, "300")), second(player(1, port, "300"));
  const auto code = first.wait(300.0), other = second.wait(300.0);
  INFO(first.err() << second.err());
  REQUIRE(code == 0);
  REQUIRE(other == 0);
  CHECK(after(first.out(), "hash ") == after(second.out(), "hash "));
  for (const std::string& said : {first.out(), second.out()})
    CHECK(said.find("went back 0 times") == std::string::npos);
}
