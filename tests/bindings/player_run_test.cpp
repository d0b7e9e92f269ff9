// What a run leaves that an error stops.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bindings/program_support.hpp"
#include "player/csv.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"

namespace sources = pantin::sources;
using namespace pantin::support;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("program: what a run had until an error stopped it is kept, and the summary names the error") {
  Folder folder;
  write_file(folder / "nan.lua", R"(
local p = scene:particle {}
scene:probe("x", function() return p.position.x end)
scene:field(scene, force.point { force = function(p, own, t) return vec(where(t > 0.1, 0 / 0, 0), 0, 0) end })
)");
  write_file(folder / "boom.lua", "scene:on('step', function() if scene.time > 0.1 then error('boom') end end)");
  write_file(folder / "late.lua", "scene:at(0.1,\nfunction() error('boom') end)");
  for (const char* scene : {"nan", "boom", "late"}) {
    const Finished result = finish({{sources::program(), "run", std::string(scene) + ".lua", "--until", "1", "--out",
                                     "a.csv", "--summary", "s.json"},
                                    {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"},
                                    folder.path,
                                    -1});
    INFO(result.err);
    CHECK(result.code == 1);
    CHECK_THAT(result.err, Contains("what there is by then is kept"));
    const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
    CHECK(summary["steps"] > 20);
    CHECK_THAT(summary["failure"].get<std::string>(), Contains(".lua:"));
    CHECK(!read_file(folder / "a.csv").empty());
    const Finished bare = use(folder, {"run", std::string(scene) + ".lua", "--until", "1"});
    CHECK_THAT(bare.err, Contains("stopped at 0.1") && !Contains("is kept"));
  }
}

TEST_CASE("program: a run's errors are those of its last step, also where laws tell their energy now and then") {
  Folder folder;
  write_file(folder / "melt.lua", R"(
scene.step, scene.gravity = 0.004, vec(0, 0, 0)
local atoms = scene:family("atoms")
for i = 0, 999 do
  scene:particle { at = 1.2 * vec(i % 10, i // 10 % 10, i // 100), velocity = vec(i % 7 - 3, i % 5 - 2, 0), family = atoms }
end
scene:interact(atoms, atoms, force.lennard_jones { epsilon = 1, sigma = 1, cutoff = 2.5 })
)");
  const Finished result = finish({{sources::program(), "run", "melt.lua", "--until", "0.012", "--summary", "s.json"},
                                  {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"},
                                  folder.path,
                                  -1});
  CHECK_THAT(result.out, Contains("energy error ") && !Contains("energy error 0 (worst 0)"));
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  CHECK(summary["error"]["worst_energy"] > 0.0);
}

TEST_CASE(
    "program: a run's last lines and its summary tell how deep shapes overlapped, which and when, where they did") {
  Folder folder;
  write_file(folder / "jam.lua", R"(
scene:ground { shape = shape.box { size = vec(0.1, 1, 0.1), name = "wall" } }
local lever = scene:box { size = vec(0.4, 0.08, 0.08), at = vec(0.23, 0, 0), points = { pivot = vec(-0.2, 0, 0) }, name = "lever" }
scene:nail(lever.pivot)
)");
  write_file(folder / "rest.lua", "scene:floor {}\nscene:box { size = 1, at = vec(0, 0.5, 0) }");
  const auto run = [&](const std::string& scene) {
    const Finished result = finish({{sources::program(), "run", scene + ".lua", "--until", "1", "--summary", "s.json"},
                                    {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"},
                                    folder.path,
                                    -1});
    CHECK(result.code == 0);
    return result;
  };
  const Finished jam = run("jam");
  CHECK_THAT(jam.out, Contains("  shapes overlapped by up to 0.02 m, 25 % of the thinner: body 'lever' and ground "
                               "'wall', at 0.004167 s\n"));
  CHECK_THAT(jam.out, Contains("  contacts of an island were solved more loosely than wanted "));
  CHECK_THAT(jam.err, Contains("body 'lever' overlaps ground 'wall' by 0.02 m since it was put there"));
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  CHECK(summary["deepest_overlap"]["depth"].get<double>() == Approx(0.02).epsilon(1e-3));
  CHECK(summary["deepest_overlap"]["things"][1] == "ground 'wall'");
  CHECK(summary["stats"]["unsolved_islands"] > 100);
  CHECK(summary["warnings"].size() == 1);

  write_file(folder / "gone.lua", R"(
local a = scene:box { size = 1, name = "a" }
scene:ground { shape = shape.box { size = 1, name = "b" } }
scene:at(0.5, function() a:remove() end)
)");
  CHECK_THAT(run("gone").out, Contains(": body 'a' (removed at 0.5 s by gone.lua:4) and ground 'b', at 0.004167 s\n"));
  write_file(folder / "forgotten.lua", R"(
local function two() return { scene:box { size = 1 }, scene:box { size = 1 } } end
local first = two()
scene:at(0.5, function()
  for _, box in ipairs(first) do box:remove() end
  for _, box in ipairs(two()) do box:remove() end
end)
)");
  CHECK_THAT(run("forgotten").out, Contains(": a body that is gone and another, at 0.004167 s\n"));

  const Finished rest = run("rest");
  CHECK_THAT(rest.out, !Contains("overlapped") && !Contains("loosely"));
  CHECK(rest.err.empty());
  CHECK_FALSE(nlohmann::json::parse(read_file(folder / "s.json")).contains("deepest_overlap"));
}

TEST_CASE("program: what contacts gave too much is told, though it was taken back and no energy error tells it") {
  Folder folder;
  write_file(folder / "rods.lua", R"(
    scene.step, scene.seed = 1 / 60, 22
    scene:floor {}
    for i = 1, 20 do
      local along = vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5):normalized() * 0.125
      local at = vec(0.1 * math.random(), 1 + 0.06 * i, 0.1 * math.random())
      scene:capsule { radius = 0.0009, from = at - along, to = at + along, density = 1400 }
    end
  )");
  const Finished done = use(folder, {"run", "rods.lua", "--until", "1", "--summary", "s.json"});
  CHECK_THAT(done.out, Contains("J too much") && Contains("which was taken back"));
  CHECK(nlohmann::json::parse(read_file(folder / "s.json"))["stats"]["gains_taken_back"] > 0.0);
}

TEST_CASE("program: what the engine does for a script ends with the script's time, and within its memory") {
  Folder folder;
  write_file(folder / "dense.lua", R"(
local group = scene:group "dense"
for i = 1, 20000 do group:add(scene:particle { at = vec(i % 100, i // 100, 0) * 1e-4, mass = 1 }) end
scene:connect_within(group, 1, force.spring { stiffness = 1, length = 1 })
)");
  const Finished slow = use(folder, {"run", "dense.lua", "--script-limit", "0.5"});
  CHECK(slow.code == 1);
  CHECK_THAT(slow.err, Contains("dense.lua:4: the script did not come back within 0.5 s"));
  for (const char* line :
       {"scene:build(structure.sheet { columns = 400, rows = 400 }, { as = 'panels', mass = 1 })",
        "local s = structure.sheet { columns = 100, rows = 100 } while true do s = s:subdivide() end"}) {
    write_file(folder / "large.lua", line);
    CHECK_THAT(use(folder, {"run", "large.lua", "--script-limit", "0.5"}).err,
               Contains("large.lua:1: the script did not come back within 0.5 s"));
  }
  const Finished large = use(folder, {"run", "dense.lua", "--script-limit", "60", "--memory-limit", "100MiB"});
  CHECK(large.code == 1);
  CHECK_THAT(large.err, Contains("the scene takes more memory than it may (--memory-limit)"));
}

TEST_CASE("program: files that a script reads, and snapshots, stay within its memory") {
  Folder folder;
  for (const char* big : {"big.csv", "big.lua"}) {
    write_file(folder / big, "");
    std::filesystem::resize_file(folder / big, std::uintmax_t{1500} << 20);
  }
  for (const char* line : {"read_table 'big.csv'", "require 'big'"}) {
    write_file(folder / "reads.lua", line);
    CHECK_THAT(use(folder, {"run", "reads.lua", "--memory-limit", "10MiB"}).err,
               Contains("has 1500 MiB; at most 2.5 are read, a quarter of --memory-limit"));
  }
  CHECK_THAT(use(folder, {"run", "big.lua"}).err, Contains("has 1500 MiB; at most 16 are read"));
  write_file(folder / "keeps.lua", R"(
scene:build(structure.sheet { columns = 200, rows = 200 }, { as = "deformable", mass = 1 })
local kept = {}
for i = 1, 80 do kept[i] = scene:snapshot() end
)");
  CHECK_THAT(use(folder, {"run", "keeps.lua", "--memory-limit", "50MiB", "--script-limit", "60"}).err,
             Contains("keeps.lua:4: the scene takes more memory than it may (--memory-limit)"));
}

TEST_CASE("program: a run's table has a row at each event that a probe counts") {
  Folder folder;
  write_file(folder / "drop.lua", R"(
    scene:floor {}
    local ball = scene:body { at = vec(0, 0.5, 0), shape = shape.ball { radius = 0.1, restitution = 0.7 } }
    local touches = 0
    scene:on("touched", ball, function() touches = touches + 1 end)
    scene:probe("touches", function() return touches end)
    scene:probe("height", function() return ball.position.y end)
  )");
  const auto run = [&](const std::string& when) {
    return use(folder, {"run", "drop.lua", "--until", "1", "--out", "t.csv", "--when", when});
  };
  REQUIRE(run("touches").code == 0);
  const auto rows = pantin::player::read_csv(read_file(folder / "t.csv"));
  REQUIRE(rows.size() >= 4);
  for (std::size_t i = 1; i + 1 < rows.size(); i++) CHECK(rows[i][1] == std::to_string(i - 1));
  CHECK(std::stod(rows[2][0]) == Approx(std::sqrt(2 * 0.4 / 9.81)).margin(0.02));
  const Finished none = run("touch");
  CHECK(none.code == 2);
  CHECK_THAT(none.err, Contains("no such probe at its start; it has touches, height"));
}

TEST_CASE("run: a state goes on to a later time only") {
  Folder folder;
  write_file(folder / "drop.lua", "scene:particle { at = vec(0, 1, 0), mass = 1 }");
  REQUIRE(use(folder, {"run", "drop.lua", "--until", "1", "--save-at", "1", "--save-to", "one.pantin"}).code == 0);
  const Finished back = use(folder, {"run", "one.pantin", "--until", "0.5"});
  CHECK(back.code == 2);
  CHECK_THAT(back.err, Contains("--until 0.5 s: one.pantin is at 1 s already"));
  CHECK(use(folder, {"run", "one.pantin", "--until", "1"}).code == 0);
}

TEST_CASE("run: an event that a removed thing ended is told with its line, and the run fails at its end") {
  Folder folder;
  const std::string things = "local p = scene:particle { name = 'p' }\nscene:at(0.1, function() p:remove() end)\n";
  write_file(folder / "at.lua", things + "scene:at(0.2, function()\nprint(p.mass) end)");
  write_file(folder / "when.lua", things + "scene:when(function()\nreturn p.mass > 2 end, print)");
  write_file(folder / "play.lua", things + "scene:play(function(wait) wait(0.2)\np.mass = 3 end)");
  for (const std::string scene : {"at", "when", "play"}) {
    const Finished result = use(folder, {"run", scene + ".lua", "--until", "0.5", "--summary", "s.json"});
    INFO(result.err);
    CHECK(result.code == 1);
    CHECK_THAT(result.err, Contains("\n" + scene + ".lua:4: particle 'p' was removed at") ||
                               StartsWith(scene + ".lua:4: particle 'p' was removed at"));
    CHECK_THAT(result.err, Contains("the run goes on"));
    const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
    CHECK(summary["time"] == 0.5);
    CHECK_THAT(summary["failure"].get<std::string>(), StartsWith(scene + ".lua:4: "));
  }
  write_file(folder / "target.lua", things + "scene:at(0.2, p, print)");
  CHECK(use(folder, {"run", "target.lua", "--until", "0.5"}).code == 0);
}
