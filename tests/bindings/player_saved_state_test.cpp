// States in files, as the program writes and opens them.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "bindings/program_support.hpp"

using namespace pantin::support;
using Catch::Contains;

namespace {

nlohmann::json summary_of(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--summary", "s.json"});
  const Finished run = use(folder, std::move(arguments));
  INFO(run.err);
  REQUIRE(run.code == 0);
  return nlohmann::json::parse(read_file(folder / "s.json"));
}

std::string complaint(const Folder& folder, std::vector<std::string> arguments) {
  const Finished run = use(folder, std::move(arguments));
  CHECK(run.code != 0);
  return run.err;
}

}  // namespace

TEST_CASE("saved_state: a run that goes on from a state comes to the bits and results of one that was not stopped") {
  Folder folder;
  write_file(folder / "swing.lua", std::string(swing) + R"(
local wait, part = 0, require "part"
scene:every(0.1, function() wait = wait + part.more scene:result("wait", wait) end)
)");
  write_file(folder / "part.lua", "return { more = 2 }");
  const auto whole = summary_of(folder, {"run", "swing.lua", "--set", "mass=3", "--until", "2", "--save-at", "1.05"});
  std::filesystem::remove(folder / "swing.lua");
  std::filesystem::remove(folder / "part.lua");
  for (const char* threads : {"1", "2"}) {
    const auto rest = summary_of(folder, {"run", "--from", "swing.pantin", "--until", "2", "--threads", threads});
    CHECK(rest["hash"] == whole["hash"]);
    CHECK(rest["results"] == whole["results"]);
    CHECK(rest["results"]["mass"] == 3.0);
  }
  CHECK(summary_of(folder, {"run", "swing.pantin", "--until", "2"})["hash"] == whole["hash"]);
  CHECK_THAT(complaint(folder, {"run", "other.lua", "--from", "swing.pantin"}),
             Contains("swing.pantin: this is a state of swing.lua, not of other.lua"));
  CHECK_THAT(complaint(folder, {"run", "--from", "swing.pantin", "--set", "mass=2"}),
             Contains("--set cannot change a saved state"));
}

TEST_CASE("saved_state: a scene whose script waits in a play goes on, too") {
  Folder folder;
  write_file(folder / "wait.lua", R"(
local ball = scene:particle {}
scene:play(function(wait) for i = 1, 50 do wait(0.1) ball:kick(vec(i, 0, 0)) scene:result("i", i) end end)
)");
  const auto whole = summary_of(folder, {"run", "wait.lua", "--until", "2", "--save-at", "1"});
  const auto rest = summary_of(folder, {"run", "--from", "wait.pantin", "--until", "2"});
  CHECK(rest["hash"] == whole["hash"]);
  CHECK(rest["results"] == whole["results"]);
}

TEST_CASE("saved_state: what cannot be saved or opened is told, and no file is lost") {
  Folder folder;
  write_file(folder / "fall.lua", "scene:particle {}");
  write_file(folder / "old.pantin", "old");
  CHECK_THAT(complaint(folder, {"run", "fall.lua", "--until", "1", "--save-at", "2", "--save-to", "old.pantin"}),
             Contains("the run ended at 1 s, before the state was to be saved at 2 s"));
  CHECK(read_file(folder / "old.pantin") == "old");
  CHECK_THAT(complaint(folder, {"run", "fall.lua", "--save-to", "x.pantin"}), Contains("--save-to needs --save-at"));
  CHECK_THAT(complaint(folder, {"run"}), Contains("a scene is missing"));
  CHECK_THAT(complaint(folder, {"run", "--from", "old.pantin"}),
             Contains("old.pantin: this is no state that Pantin saved"));
  write_file(folder / "names.lua", R"(
local names = { "a.txt", "../a.pantin", "/tmp/a.pantin", "old.pantin" }
for k, name in ipairs(names) do scene:at(0.1 * k, function() scene:save(name) end) end
)");
  CHECK_THAT(complaint(folder, {"run", "names.lua", "--until", "1"}),
             Contains("names.lua:3: save: 'a.txt' must end in .pantin"));
  write_file(folder / "empty.lua", "scene:at(0.1,\nfunction() scene:save('') end)");
  CHECK_THAT(complaint(folder, {"run", "empty.lua", "--until", "1"}),
             Contains("empty.lua:2: save: argument 1, the file, must not be empty"));
  write_file(folder / "over.lua", "scene:at(0.1, function() scene:save('old.pantin') end)");
  CHECK_THAT(complaint(folder, {"run", "over.lua", "--until", "1"}),
             Contains("over.lua:1: save: 'old.pantin' is a file that is no state; it is left as it is"));
  CHECK(read_file(folder / "old.pantin") == "old");
}
