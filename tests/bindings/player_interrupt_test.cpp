// Ctrl-C and SIGTERM, while the program and a report are at work.
#include "player/interrupt.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "bindings/program_support.hpp"
#include "bindings/study_support.hpp"
#include "player/report.hpp"

namespace sources = pantin::sources;
using namespace pantin::support;
using Catch::Contains;

namespace {

constexpr double patience = 120.0;  // [s] however busy the machine is

/// Waits until a program has printed this; false where it ends without.
bool says(Process& process, const std::string& words) {
  bool ended = false;
  while (process.out().find(words) == std::string::npos) {
    if (ended) return false;
    ended = process.wait(0.01).has_value();
  }
  return true;
}

}  // namespace

TEST_CASE("program: Ctrl-C ends with what there is") {
  Folder folder;
  write_file(folder / "swing.lua", swing + std::string("scene:at(0.1, function() print('swings') end)"));
  Process process(
      options({"run", "swing.lua", "--until", "1e6", "--out", "a.csv", "--summary", "s.json"}, folder.path));
  REQUIRE(says(process, "swings"));
  process.signal(SIGINT);
  REQUIRE(process.wait(patience) == 0);
  auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  CHECK(summary["steps"].get<std::size_t>() >= 24);
  CHECK(lines(read_file(folder / "a.csv")) == summary["steps"].get<std::size_t>() + 1);
  CHECK_THAT(process.err(), Contains("stopped at"));
}

TEST_CASE("program: Ctrl-C before the state was saved is a failure") {
  Folder folder;
  write_file(folder / "swing.lua", swing + std::string("scene:at(0.1, function() print('swings') end)"));
  Process process(options({"run", "swing.lua", "--until", "1e6", "--save-at", "9e5", "--out", "a.csv"}, folder.path));
  REQUIRE(says(process, "swings"));
  process.signal(SIGINT);
  REQUIRE(process.wait(patience) == 1);
  CHECK_THAT(process.err(), Contains("before the state was to be saved at 9e+05"));
  CHECK(folder.files() == std::vector<std::string>{"a.csv", "swing.lua"});
}

TEST_CASE("program: a terminal that goes away ends it with what there is, and SIGQUIT leaves nothing half written") {
  Folder folder;
  write_file(folder / "swing.lua", swing + std::string("scene:at(0.1, function() print('swings') end)"));
  const std::vector<std::string> run = {"run", "swing.lua", "--until", "1e6", "--out", "a.csv"};
  const auto kill = [&](Process::Options process_options, int number) {
    Process process(process_options);
    REQUIRE(says(process, "swings"));
    process.signal(number);
    return process.wait(patience);
  };
  Process::Options bare = options({}, folder.path);
  bare.arguments = {"bash", "-c", "ulimit -c 0; exec \"$0\" \"$@\"", sources::program()};
  bare.arguments.insert(bare.arguments.end(), run.begin(), run.end());
  CHECK(kill(bare, SIGQUIT) == 128 + SIGQUIT);
  CHECK(folder.files() == std::vector<std::string>{"swing.lua"});
  CHECK(kill(options(run, folder.path), SIGHUP) == 0);
  CHECK(folder.files() == std::vector<std::string>{"a.csv", "swing.lua"});
}

TEST_CASE("program: what waits in a play is opened again no longer than until Ctrl-C") {
  Folder folder;
  write_file(folder / "wait.lua",
             "local n = 0 scene:on('step', function() n = n + 1 if n == 20 then print('on its way') "
             "end for i = 1, n > 20 and 4e6 or 0 do end end)\n"
             "scene:play(function(wait) wait(1e6) end)");
  const Finished saved = use(folder, {"run", "wait.lua", "--until", "0.7", "--save-at", "0.5", "--script-limit", "0"});
  REQUIRE(saved.code == 0);
  Process process(
      options({"run", "wait.pantin", "--until", "0.6", "--script-limit", "0", "--out", "a.csv"}, folder.path));
  REQUIRE(says(process, "on its way"));
  process.signal(SIGINT);
  CHECK(process.wait(patience) == 1);
  CHECK_THAT(process.err(), Contains("on the way to the saved state") || Contains("was interrupted"));
  CHECK(folder.files() == std::vector<std::string>{"wait.lua", "wait.pantin"});
}

TEST_CASE("program: what nothing can stop ends it, and leaves nothing half-written", "[slow]") {
  Folder folder;
  write_file(folder / "keys.lua", R"(scene:at(0.01, function()
    local t, step, count = {}, 2^19 - 1 | 0, 2^18 | 0
    for i = 1, count do t[i * step] = true end
    t[-5] = 1
  end))");
  Process process(options({"run", "keys.lua", "--script-limit", "0.2", "--out", "a.csv"}, folder.path));
  CHECK(process.wait(patience) == 1);
  CHECK_THAT(process.err(), Contains("cannot be stopped"));
  CHECK(folder.files().size() == 1);
}

TEST_CASE("program: a step that takes far more memory than it may ends it", "[slow]") {
  Folder folder;
  write_file(folder / "string.lua",
             "local points = {} for i = 1, 12000 do points[i] = scene:particle { at = vec(i * 1e-3, 0, 0) } end\n"
             "scene:string(points)");
  Process process(options({"run", "string.lua", "--until", "0.1", "--memory-limit", "100MiB"}, folder.path));
  CHECK(process.wait(patience) == 1);
  CHECK_THAT(process.err(), Contains("--memory-limit") && Contains("cannot be stopped"));
}

TEST_CASE("program: one Ctrl-C ends a script that loops, whatever its limit, and a second one kills without a trace") {
  Folder folder;
  write_file(folder / "opens.lua", "local s = ('a'):rep(1e6) print('loops')\ns:find('.-.-.-b')");
  write_file(folder / "steps.lua", "scene:at(0.1, function() print('loops')\nwhile true do end end)");
  const auto start = [&](const char* scene) {
    return std::make_unique<Process>(
        options({"run", scene, "--script-limit", "0", "--out", "a.csv", "--summary", "s.json"}, folder.path));
  };
  SECTION("while the scene is built") {
    auto process = start("opens.lua");
    REQUIRE(says(*process, "loops"));
    process->signal(SIGINT);
    CHECK(process->wait(patience) == 1);
    CHECK(process->err() == "opens.lua:2: the script was interrupted\n");
    CHECK(folder.files().size() == 2);
  }
  SECTION("in a step: what there is is kept") {
    auto process = start("steps.lua");
    REQUIRE(says(*process, "loops"));
    process->signal(SIGINT);
    CHECK(process->wait(patience) == 0);
    CHECK_THAT(process->err(), Contains("steps.lua:2: the script was interrupted") && Contains("stopped at 0.1 s"));
    CHECK(nlohmann::json::parse(read_file(folder / "s.json"))["steps"] == 24);
    CHECK(folder.files().size() == 4);
  }
  SECTION("twice") {
    auto process = start("steps.lua");
    REQUIRE(says(*process, "loops"));
    process->signal(SIGSTOP);  // it gets both at once, however busy the machine is
    process->signal(SIGINT);
    process->signal(SIGTERM);
    process->signal(SIGCONT);
    const int code = process->wait(patience).value_or(-1);
    CHECK((code == 128 + SIGINT || code == 128 + SIGTERM));
    CHECK(folder.files().size() == 2);
  }
}

TEST_CASE("program: Ctrl-C ends a report with what its runs tell") {
  Folder folder;
  write_file(folder / "swing.lua", std::string("print('run')\n") + swing);
  Process process(options({"report", "swing.lua", "--until", "20"}, folder.path));
  std::string twelve;
  for (int i = 0; i < 12; i++) twelve += "run\n";
  REQUIRE(says(process, twelve));  // by then the first ones, which only look what a run would cost, are over
  process.signal(SIGINT);
  CHECK(process.wait(patience) == 0);
  CHECK_THAT(process.out(), Contains("verlet"));
  CHECK(folder.files() == std::vector<std::string>{"swing-report.json", "swing-report.svg", "swing.lua"});
}

TEST_CASE("program: Ctrl-C ends a report that has nothing to tell yet, and leaves nothing") {
  Folder folder;
  write_file(folder / "swing.lua", swing + std::string("print('is built')\nwhile true do end"));
  Process process(options({"report", "swing.lua", "--script-limit", "0"}, folder.path));
  REQUIRE(says(process, "is built"));
  process.signal(SIGINT);
  CHECK(process.wait(patience) == 1);
  CHECK_THAT(process.err(), Contains("was interrupted"));
  CHECK(folder.files() == std::vector<std::string>{"swing.lua"});
}

TEST_CASE("report: Ctrl-C ends it with what its runs tell, as early as after the first") {
  const Folder folder;
  write_file(folder / "scene.lua", swing);
  using namespace pantin::player;
  RunOptions of_scene;
  of_scene.scene = folder / "scene.lua";
  of_scene.until = 1.0;
  const auto stopped_at = [&](std::size_t run) {
    const Interrupt interrupt;
    std::set<std::string> told;
    return study(of_scene, folder.path, 5.0, [&](const std::string& what, double) {
      if (told.insert(what).second && told.size() == run) std::raise(SIGINT);
    });
  };
  CHECK_THROWS_WITH(stopped_at(1), "report: stopped before there was anything to tell");
  for (const std::size_t run : {2u, 3u, 6u}) {
    const Study study = stopped_at(run);
    CHECK_FALSE(Interrupt::asked());  // what is done next in the same process
    CHECK(study.runs.size() >= 1);
    CHECK(study.runs.size() < run);
    CHECK_THAT(report_text(study, 1.0), Catch::Contains(advice(study)));
  }
}
