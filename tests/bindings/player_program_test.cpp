// The built program as a person uses it: exit codes, messages, outputs.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bindings/program_support.hpp"

namespace sources = pantin::sources;
using namespace pantin::support;
using Catch::Contains;

namespace {

const char* const gas = R"(
scene.gravity = vec(0, 0, 0)
local atoms = scene:family "atoms"
for i = 1, 2000 do
  scene:particle { family = atoms, at = vec(i % 13, i // 13 % 13, i // 169) * 1.1, velocity = vec(math.random(), 0, 1) }
end
scene:interact(atoms, atoms, force.lennard_jones { epsilon = 1, sigma = 1 })
scene:field(atoms, force.thermostat { temperature = 1, rate = 1 })
)";

const char* const ties = R"(
local atoms = scene:family("atoms", { radius = 0.3, attributes = { charge = 1 } })
local own = force.pair { parameters = { k = 2 }, potential = function(r, a, b, own) return own.k * r^2 * a.mass end }
local called = force.pair { tension = function(r, rate, a) if r == 77 then return 0 end return 0.1 * a.charge * rate end }
local bend = force.many { count = 3, potential = function(p) return p[1].mass * (p[1].position - p[3].position):dot(vec(1, 0, 0))^2 end }
local last
for i = 1, 60 do
  local p = scene:particle { family = atoms, at = vec(i % 4, i // 4 % 4, i // 16), velocity = vec(math.random(), 0, 1) }
  scene:connect(p, vec(0, i, 0), force.spring { stiffness = 1, length = 1, damping = 0.1 })
  if i % 3 == 0 then scene:connect(p, vec(i, 0, 1), own) end
  if i % 5 == 0 then scene:connect(p, vec(i, 1, 1), called) end
  if last then scene:connect({ p, vec(1, 1, i), last }, bend) end
  last = p
end
for i = 1, 6 do
  local b = scene:body { mass = 1, inertia = vec(1e-5, 1, 1), at = vec(0, 0, -2 * i), points = { p = vec(0.5, 0.1, 0), q = vec(-0.5, 0, 0) } }
  if i % 2 == 0 then scene:nail(b.p) end
  scene:connect(b.q, vec(0, 1, 0), force.spring { stiffness = 5, length = 1 })
end
scene:interact(atoms, atoms, force.lennard_jones { epsilon = 0.1, sigma = 0.5 })
scene:interact(atoms, atoms, force.repel { stiffness = 10 })
scene:interact(atoms, atoms, force.coulomb { constant = 0.1 })
scene:field(atoms, force.thermostat { temperature = 1, rate = 1 })
)";

}  // namespace

TEST_CASE("program: help and version") {
  Folder folder;
  Finished help = use(folder, {"--help"});
  CHECK(help.code == 0);
  CHECK_THAT(help.out, Contains("play") && Contains("run") && Contains("test") && Contains("bench"));
  CHECK_THAT(help.out, !Contains("meta"));
  Finished version = use(folder, {"--version"});
  CHECK(version.code == 0);
  CHECK_THAT(version.out, Contains("pantin 0."));
}

TEST_CASE("program: an end before the first step is an error that names both") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Finished result = use(folder, {"run", "swing.lua", "--until", "5", "--set", "scene.step=1e9"});
  CHECK(result.code != 0);
  CHECK_THAT(result.err, Contains("5 s") && Contains("1e+09 s"));
}

TEST_CASE("program: wrong use exits 2 with one line") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  std::vector<std::vector<std::string>> wrong = {
      {},
      {"dance"},
      {"run"},
      {"run", "missing.lua"},
      {"run", "no such scene"},
      {"run", "swing.lua", "--out", "a.txt"},
      {"run", "swing.lua", "--set", "massive=3"},
      {"run", "swing.lua", "--set", "mass=heavy"},
      {"run", "swing.lua", "--out", "missing/a.csv"},
      {"run", "swing.lua", "--out", "a.csv", "--out", "./a.csv"},
      {"run", "swing.lua", "--until", "nan"},
      {"bench", "no such benchmark"},
  };
  for (const auto& arguments : wrong) {
    Finished result = use(folder, arguments);
    INFO(result.err);
    CHECK(result.code == 2);
    CHECK(result.err.starts_with("pantin: "));
    CHECK(lines(result.err) == 1);
    CHECK(folder.files() == std::vector<std::string>{"swing.lua"});
  }
}

TEST_CASE("program: a table and a summary of a run") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Finished result = use(folder, {"run", "swing.lua", "--until", "0.5", "--set", "mass=2", "--set", "scene.step=1/100",
                                 "--out", "a.csv", "--summary", "s.json"});
  INFO(result.err);
  REQUIRE(result.code == 0);
  CHECK(result.err.empty());
  CHECK(folder.files() == std::vector<std::string>{"a.csv", "s.json", "swing.lua"});

  std::istringstream table(read_file(folder / "a.csv"));
  std::string line;
  std::getline(table, line);
  CHECK(line == "time,height");
  double time = 0.0, height = 0.0;
  int rows = 0;
  for (char comma = 0; table >> time >> comma >> height; rows++) {
    REQUIRE(comma == ',');
    REQUIRE(height < 0.0);
  }
  CHECK(rows == 50);
  CHECK(time == Approx(0.5));

  auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  CHECK(summary["steps"] == 50);
  CHECK(summary["time"].get<double>() == time);
  CHECK(summary["hash"].get<std::string>().size() == 16);
  CHECK(summary["results"]["mass"] == 2.0);
  CHECK(summary["energy"]["total"].get<double>() ==
        Approx(summary["energy"]["kinetic"].get<double>() + summary["energy"]["potential"].get<double>()));
  CHECK(summary["energy"]["potential"].get<double>() == Approx(2 * 9.81 * height));
  CHECK(summary["error"]["worst_energy"].get<double>() >= summary["error"]["energy"].get<double>());
  CHECK(summary["stats"]["articulates"] == 1);
  CHECK(summary["stats"]["newton_iterations"].get<int>() >= 50);
  CHECK(summary["ns_per_phase"]["drift"].get<double>() > 0.0);
  CHECK(summary["warnings"].is_array());
  CHECK(summary["notices"].is_array());
}

TEST_CASE("program: laws end in the same bits on one, two and four threads") {
  Folder folder;
  write_file(folder / "gas.lua", gas);
  std::string wanted;
  for (const char* threads : {"1", "2", "4"}) {
    REQUIRE(use(folder, {"run", "gas.lua", "--until", "0.2", "--threads", threads, "--summary", "gas.json"}).code == 0);
    const std::string hash = nlohmann::json::parse(read_file(folder / "gas.json"))["hash"];
    if (wanted.empty()) wanted = hash;
    CHECK(hash == wanted);
  }
}

TEST_CASE("program: what memory held before does not reach a scene") {
  Folder folder;
  write_file(folder / "ties.lua", ties);
  std::string wanted;
  for (const char* held : {"0", "85", "170", "255"})
    for (const char* threads : {"1", "2"}) {
      Process::Options run =
          options({"run", "ties.lua", "--until", "0.2", "--threads", threads, "--summary", "ties.json"}, folder.path);
      run.environment.push_back(std::string("MALLOC_PERTURB_=") + held);
      const Finished finished = finish(run);
      CAPTURE(held, threads, finished.err);
      REQUIRE(finished.code == 0);
      const std::string hash = nlohmann::json::parse(read_file(folder / "ties.json"))["hash"];
      if (wanted.empty()) wanted = hash;
      CHECK(hash == wanted);
    }
}

TEST_CASE("program: two runs end in the same bits") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  for (const char* name : {"1.json", "2.json"})
    REQUIRE(use(folder, {"run", "swing.lua", "--until", "1", "--summary", name}).code == 0);
  CHECK(nlohmann::json::parse(read_file(folder / "1.json"))["hash"] ==
        nlohmann::json::parse(read_file(folder / "2.json"))["hash"]);
}

TEST_CASE("program: errors of a scene that takes no step exit 1 with file and line, and leave no output") {
  Folder folder;
  struct Case {
    std::string script, line, says, limit = "1";
  };
  std::vector<Case> cases = {
      {"local x = (1", "bad.lua:1: ", ""},
      {"\nscene:body { mass = -1, points = { vec(0, 0, 0) } }", "bad.lua:2: ", "mass"},
      {"scene.colour = 3", "bad.lua:1: ", "colour"},
      {"scene:on('step', function()\n  local p = nil + 1\nend)", "bad.lua:2: ", ""},
      {"while true do\nend", "bad.lua:1: ", ""},
      {"local t = {}\nwhile true do t[#t + 1] = ('x'):rep(1e6) .. #t end", "bad.lua:2: ", "memory", "60"},
  };
  for (const Case& bad : cases) {
    write_file(folder / "bad.lua", bad.script);
    Finished result = use(folder, {"run", "bad.lua", "--until", "1", "--script-limit", bad.limit, "--memory-limit",
                                   "64MiB", "--out", "a.csv", "--summary", "s.json"});
    INFO(bad.script << "\n" << result.err);
    CHECK(result.code == 1);
    CHECK_THAT(result.err, Contains(bad.line) && Contains(bad.says));
    CHECK_FALSE(result.err.starts_with("pantin: "));
    CHECK(lines(result.err) == 1);
    CHECK(folder.files() == std::vector<std::string>{"bad.lua"});
  }
}

TEST_CASE("program: the scene says when to end") {
  Folder folder;
  write_file(folder / "a.lua", "scene.duration = 0.25\nscene:particle {}\n");
  write_file(folder / "b.lua", "scene:particle {}\nscene:at(0.125, function() scene:finish() end)\n");
  write_file(folder / "later.lua", "scene.duration = 0.25\nscene:at(0.125, function() scene.duration = 0.5 end)\n");
  write_file(folder / "sooner.lua", "scene:at(0.125, function() scene.duration = 0.25 end)\n");
  REQUIRE(use(folder, {"run", "a.lua", "--summary", "a.json"}).code == 0);
  REQUIRE(use(folder, {"run", "b.lua", "--summary", "b.json"}).code == 0);
  CHECK(nlohmann::json::parse(read_file(folder / "a.json"))["time"].get<double>() == Approx(0.25));
  CHECK(nlohmann::json::parse(read_file(folder / "b.json"))["time"].get<double>() == Approx(0.125).margin(1.0 / 240));
  for (const auto& [name, end] : {std::pair("later", 0.5), {"sooner", 0.25}}) {
    const std::string file = std::string(name) + ".lua", table = std::string(name) + ".csv";
    REQUIRE(use(folder, {"run", file, "--summary", "s.json"}).code == 0);
    CHECK(nlohmann::json::parse(read_file(folder / "s.json"))["time"].get<double>() == Approx(end));
    REQUIRE(use(folder, {"sweep", file, "--seeds", "1", "--out", table}).code == 0);
    CHECK_THAT(read_file(folder / table), Contains("," + std::string(end == 0.5 ? "0.5" : "0.25") + ","));
    CHECK(use(folder, {"run", file, "--until", "0.375"}).out.find("0.375") != std::string::npos);
  }
}

TEST_CASE("program: what was set for the time at which the run ends is told to be undone") {
  Folder folder;
  write_file(folder / "end.lua",
             "local p = scene:particle {}\nscene:at(0.5, p, function() end)\n"
             "scene:at(0.4, p, function() end)\nscene:at(0.6, p, function() end)");
  const Finished result = use(folder, {"run", "end.lua", "--until", "0.5"});
  CHECK_THAT(result.out, Contains("what was set for 0.5 s, when the run ends, is not done: end.lua:2\n"));
  CHECK(lines(result.out) == 3);
}

TEST_CASE("program: where ties contradict each other no shorter step is advised") {
  Folder folder;
  write_file(folder / "torn.lua", R"(
    local p = {}
    for i = 0, 2 do p[i] = scene:particle { at = vec(i, 0, 0), mass = 1 } end
    scene:nail(p[0])
    for i = 1, 2 do scene:rod(p[i - 1], p[i]) end
    scene:follow(p[2], function(t) return vec(2 + t, 0, 0) end)
  )");
  const Finished torn = use(folder, {"run", "torn.lua", "--until", "1"});
  CHECK_THAT(torn.out, Contains("ties cannot be kept, which no shorter step mends") && !Contains("report"));
}

TEST_CASE("program: a run whose energy went wrong says so, and what finds a better step") {
  Folder folder;
  const std::string spring = "scene.integrator = 'euler'\nlocal p = scene:particle { at = vec(1, 0, 0) }\n";
  write_file(folder / "good.lua", spring);
  write_file(folder / "bad.lua", spring + R"(
    scene:field(scene, force.point { potential = function(p) return 1e6 * p.position.x ^ 2 end })
  )");
  CHECK_THAT(use(folder, {"run", "good.lua", "--until", "0.1"}).out, !Contains("pantin report"));
  const std::string told = use(folder, {"run", "bad.lua", "--until", "0.1", "--summary", "bad.json"}).out;
  CHECK_THAT(read_file(folder / "bad.json"), Contains("the energy went wrong"));
  CHECK_THAT(told, Contains("`pantin report bad.lua`") && !Contains("without an energy"));
  write_file(folder / "pushed.lua", spring + R"(
    scene:field(scene, force.point { name = "shove", force = function(p) return -2e6 * p.position end })
  )");
  CHECK_THAT(use(folder, {"run", "pushed.lua", "--until", "0.1"}).out,
             Contains("`pantin report pushed.lua`") && Contains("without an energy of their own act shove"));
  write_file(folder / "chase.lua", R"(
    scene.gravity = vec(0, 0, 0)
    local leader, other = scene:particle { at = vec(1, 0, 0), velocity = vec(0, 9, 0) }, scene:particle {}
    scene:field(scene:group("others"):add(other), force.point { name = "pull", potential = function(p)
      local d = p.position - leader.position return 20 * d:dot(d) end })
  )");
  CHECK_THAT(use(folder, {"run", "chase.lua", "--until", "1"}).out,
             Contains("which no shorter step mends: pull (position of a thing)"));
}

TEST_CASE("program: tests in Lua") {
  Folder folder;
  write_file(folder / "good.lua", "test('a sum', function() expect(1 + 1):equal(2) end)");
  write_file(folder / "bad.lua", "test('a sum', function()\nexpect(1 + 1):equal(3) end)");
  write_file(folder / "none.lua", "");
  Finished good = use(folder, {"test", "good.lua"});
  CHECK(good.code == 0);
  CHECK_THAT(good.out, Contains("1 passed, 0 failed"));
  Finished bad = use(folder, {"test", "bad.lua"});
  CHECK(bad.code == 1);
  CHECK_THAT(bad.out, Contains("bad.lua:2") && Contains("0 passed, 1 failed"));
  CHECK(use(folder, {"test", "none.lua"}).code == 1);
  CHECK(use(folder, {"test", "missing.lua"}).code == 2);
}

TEST_CASE("program: a picture and films", "[slow]") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Finished result = use(folder, {"run", "swing.lua", "--until", "0.5", "--size", "160x120", "--out", "a.png", "--out",
                                 "a.mp4", "--out", "a.gif", "--out", "a.webp"});
  INFO(result.err);
  REQUIRE(result.code == 0);
  CHECK(read_file(folder / "a.png").substr(1, 3) == "PNG");
  CHECK(read_file(folder / "a.mp4").substr(4, 4) == "ftyp");
  CHECK(read_file(folder / "a.gif").substr(0, 4) == "GIF8");
  CHECK(read_file(folder / "a.webp").substr(8, 4) == "WEBP");
  CHECK(folder.files().size() == 5);
  Finished count = finish({{"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                            "stream=nb_read_frames", "-of", "csv=p=0", folder / "a.mp4"},
                           {},
                           "",
                           -1});
  CHECK(std::stoi(count.out) == 31);
}

TEST_CASE("program: play without a display says so and makes a picture and a film", "[slow]") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Finished result = use(folder, {"play", "swing.lua", "--until", "0.25", "--size", "160x120"});
  INFO(result.err);
  CHECK(result.code == 0);
  CHECK_THAT(result.err, Contains("no display"));
  CHECK(folder.files() == std::vector<std::string>{"swing.lua", "swing.mp4", "swing.png"});
}

TEST_CASE("program: a report ends in what to choose, and leaves two files") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Finished told = use(folder, {"report", "swing.lua", "--until", "0.5"});
  CHECK(told.code == 0);
  CHECK_THAT(told.out, Contains("verlet") && Contains("choose scene.step = 1/"));
  CHECK(folder.files() == std::vector<std::string>{"swing-report.json", "swing-report.svg", "swing.lua"});
  const auto json = nlohmann::json::parse(read_file(folder / "swing-report.json"));
  CHECK(json["runs"].size() >= 10);
  CHECK(use(folder, {"report"}).code == 2);
  CHECK(use(folder, {"report", "nothing"}).code == 2);
  CHECK(use(folder, {"report", "swing.lua", "--until", "0.001"}).code == 1);
}

TEST_CASE("program: pictures and films are the same to the bit each time, with views too", "[slow]") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  for (const char* name : {"a", "b"}) {
    const std::string stem = name;
    const Finished made = use(folder, {"run", "swing.lua", "--until", "0.2", "--size", "160x90", "--view",
                                       "forces,trails,dark", "--out", stem + ".png", "--out", stem + ".gif"});
    INFO(made.err);
    REQUIRE(made.code == 0);
  }
  CHECK(read_file(folder / "a.png") == read_file(folder / "b.png"));
  CHECK(read_file(folder / "a.gif") == read_file(folder / "b.gif"));
}

TEST_CASE("a scene that goes back in time for ever is stopped, and told") {
  const Folder folder;
  write_file(folder / "again.lua",
             "scene:particle{} scene:on('step', function() if scene.time > 0.25 then scene:reset() end end)");
  write_file(folder / "again_test.lua", "test('again', function() open('again.lua'):advance(1) end)");
  const Finished run = use(folder, {"run", "again.lua", "--until", "1"});
  CHECK(run.code == 1);
  CHECK_THAT(run.err, Contains("goes back in time again and again, and comes no farther than 0.25"));
  const Finished tested = use(folder, {"test", "."});
  CHECK(tested.code == 1);
  CHECK_THAT(tested.out, Contains("goes back in time again and again"));
}
