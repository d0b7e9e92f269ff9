// `pantin test fuzz`, for a moment; and that what it found once stays mended.
#include "player/fuzz.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "support/process.hpp"
#include "support/sources.hpp"

using namespace pantin;
using player::Find;

namespace {

std::vector<std::string> found_once() {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(sources::folder() + "/tests/corpus"))
    if (file.path().extension() == ".lua") paths.push_back(file.path());
  std::ranges::sort(paths);
  return paths;
}

void check_random_scenes(std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t seed = first; seed <= last; seed++) {
    CAPTURE(seed);
    const Find find =
        player::examine(player::fuzz_source(player::random_scene(seed, sources::folder())), sources::folder());
    CAPTURE(find.text);
    CHECK(find.kind == "");
  }
}

}  // namespace

TEST_CASE("fuzz: random scenes of fixed seeds break no promise") { check_random_scenes(1, 12); }

TEST_CASE("fuzz: more random scenes of fixed seeds break no promise", "[slow]") { check_random_scenes(13, 40); }

TEST_CASE("fuzz: what was found once stays mended") {
  for (const std::string& path : found_once()) {
    CAPTURE(path);
    const Find find = player::examine(support::read_file(path), sources::folder());
    CAPTURE(find.text);
    CHECK(find.kind == "");
  }
}

TEST_CASE("fuzz: a seed has its scene, and no two have the same") {
  const auto scene = [](std::uint64_t seed) { return player::random_scene(seed, sources::folder()); };
  CHECK(scene(7) == scene(7));
  CHECK(scene(7) != scene(8));
}

TEST_CASE("fuzz: a scene that stops with an error told is fine") {
  CHECK(player::examine("error('no')", sources::folder()).kind == "");
  CHECK(player::examine("scene:particle().nothing = 1", sources::folder()).kind == "");
}

TEST_CASE("fuzz: a scene that runs another way each time is found") {
  const std::string source = R"(
    local p = scene:particle { velocity = vec(1, 0, 0) }
    local steps = 0
    scene:on("step", function() steps = steps + 1 p:push(vec(steps > 25 and steps or 0, 0, 0)) end)
  )";
  CHECK(player::examine(source, sources::folder()).kind == "snapshot");  // which keeps no locals
}

TEST_CASE("fuzz: statements that a fault does not need are left out") {
  const std::vector<std::string> all = {"a", "b", "c", "d", "e", "f", "g"};
  int asked = 0;
  const auto fails = [&](const std::vector<std::string>& some) {
    asked++;
    return std::ranges::count(some, "b") && std::ranges::count(some, "f");
  };
  CHECK(player::smallest(all, fails, 10.0) == std::vector<std::string>{"b", "f"});
  CHECK(asked < 30);
  CHECK(player::smallest(all, fails, 0.0) == all);
}
