// `pantin test fuzz`, for a moment; and that what it found once stays mended.
#include "player/fuzz.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "base/check.hpp"
#include "bindings/program_support.hpp"

using namespace pantin;
using player::Find;

namespace {

std::vector<std::string> found_once(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(sources::folder() + "/tests/" + folder))
    if (file.path().extension() == ".lua") paths.push_back(file.path());
  std::ranges::sort(paths);
  return paths;
}

/// By the program, since these tests have threads.
support::Finished look_at(const support::Folder& folder, const std::vector<std::string>& files) {
  std::vector<std::string> arguments = {"test", "fuzz"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  return support::use(folder, arguments);
}

support::Finished look_at_text(const std::string& source) {
  support::Folder folder;
  support::write_file(folder / "scene.lua", source);
  return look_at(folder, {"scene.lua"});
}

void check_scenes(const support::Folder& folder, const std::vector<std::string>& files) {
  const support::Finished looked = look_at(folder, files);
  CHECK(looked.code == 0);
  CHECK(looked.out == text(files.size(), " scenes, 0 finds\n"));
  CHECK(looked.err == "");
}

void check_random_scenes(std::uint64_t first, std::uint64_t last) {
  support::Folder folder;
  std::vector<std::string> files;
  for (std::uint64_t seed = first; seed <= last; seed++) {
    files.push_back(folder / text("seed_", seed, ".lua"));
    support::write_file(files.back(), player::fuzz_source(player::random_scene(seed, sources::folder())));
  }
  check_scenes(folder, files);
}

}  // namespace

TEST_CASE("fuzz: random scenes of fixed seeds break no promise") { check_random_scenes(1, 12); }

TEST_CASE("fuzz: more random scenes of fixed seeds break no promise", "[slow]") { check_random_scenes(13, 40); }

TEST_CASE("fuzz: what was found once stays mended") { check_scenes({}, found_once("corpus")); }

TEST_CASE("fuzz: what was found once and takes its time stays mended", "[slow]") {
  check_scenes({}, found_once("corpus/slow"));
}

TEST_CASE("fuzz: a seed has its scene, and no two have the same") {
  const auto scene = [](std::uint64_t seed) { return player::random_scene(seed, sources::folder()); };
  CHECK(scene(7) == scene(7));
  CHECK(scene(7) != scene(8));
}

TEST_CASE("fuzz: a scene that stops with an error told is fine, and one that cannot be opened is told") {
  CHECK(look_at_text("scene:particle() scene:at(0, function() error('no') end)").code == 0);
  for (const char* source : {"error('no')", "scene:particle().nothing = 1", "no Lua"}) {
    const support::Finished looked = look_at_text(source);
    CHECK(looked.code == 1);
    CHECK_THAT(looked.out, Catch::StartsWith("scene.lua: cannot be opened: fuzz.lua:1: ") &&
                               Catch::Contains("1 scenes, 0 finds, 1 not opened\n"));
  }
}

TEST_CASE("fuzz: a scene that runs another way each time is found") {
  const std::string source = R"(
    local p = scene:particle { velocity = vec(1, 0, 0) }
    local steps = 0
    scene:on("step", function() steps = steps + 1 p:push(vec(steps > 25 and steps or 0, 0, 0)) end)
  )";
  const support::Finished looked = look_at_text(source);
  CHECK(looked.code == 1);
  CHECK_THAT(looked.out, Catch::Contains("snapshot"));  // which keeps no locals
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
