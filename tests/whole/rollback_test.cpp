// Two processes that play one game over UDP, as examples/rollback does, never differ.
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
