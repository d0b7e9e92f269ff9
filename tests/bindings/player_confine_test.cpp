// `--untrusted`, attacked from within the process; see tests/preload/attacks.cpp.
#include "player/confine.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "bindings/program_support.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

/// What was allowed, each with a semicolon.
std::string allowed(const std::string& told) {
  std::string all;
  for (std::size_t at = 0; (at = told.find("ALLOWED ", at)) != std::string::npos; at++)
    all += told.substr(at + 8, told.find('\n', at) - at - 8) + "; ";
  return all;
}

}  // namespace

TEST_CASE("confine: a process that runs a stranger's scene reaches nothing but its folder and its outputs") {
  if (sources::preload("attacks").empty()) return;
  const std::string command = GENERATE("run", "report", "test");
  support::Folder folder;
  std::filesystem::create_directory(folder.path / "out");
  std::filesystem::create_symlink("/etc/passwd", folder.path / "link");
  support::write_file(folder / "attacked.lua", command == "test" ? "test('nothing', function() end)" : support::swing);
  std::vector<std::string> arguments = {command, "--untrusted", "attacked.lua"};
  const bool writes = command == "run" || command == "report";
  if (command == "run") arguments.insert(arguments.end(), {"--until", "0.1", "--out", "out/table.csv"});
  if (command == "report") arguments.insert(arguments.end(), {"--until", "0.1", "--out", "out/told"});
  support::Process::Options options = support::options(arguments, folder.path);
  options.environment.push_back("LD_PRELOAD=" + sources::preload("attacks"));
  const support::Finished done = support::finish(options);
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.err, Contains("ALLOWED reads the scene's folder"));
  CHECK((done.err.find("ALLOWED writes beside the outputs") != std::string::npos) == writes);
  CHECK(support::lines(done.err) >= 28);
  CHECK(allowed(done.err) ==
        (writes ? "reads the scene's folder; writes beside the outputs; " : "reads the scene's folder; "));
}

TEST_CASE("confine: processes of a stranger's sweep reach nothing but its folder") {
  if (sources::preload("attacks").empty()) return;
  support::Folder folder;
  std::filesystem::create_directory(folder.path / "out");
  std::filesystem::create_symlink("/etc/passwd", folder.path / "link");
  support::write_file(folder / "attacked.lua", support::swing);
  support::Process::Options options = support::options({"sweep", "--untrusted", "attacked.lua", "--seeds", "1:2",
                                                        "--jobs", "1", "--until", "0.1", "--out", "out/table.csv"},
                                                       folder.path);
  options.environment.push_back("LD_PRELOAD=" + sources::preload("attacks"));
  options.environment.push_back("PANTIN_ATTACK=children");
  const support::Finished done = support::finish(options);
  INFO(done.err);
  CHECK(done.code == 0);
  const std::string each = "reads the scene's folder; ";
  CHECK(support::lines(done.err) >= 2 * 29);
  CHECK(allowed(done.err) == each + each);  // of the process that looks, and of the one that runs the cases
}

TEST_CASE("confine: a stranger's scene has the threads that it was given") {
  const std::string command = GENERATE("run", "test");
  support::Folder folder;
  support::write_file(
      folder / "scene.lua",
      "local f = scene:family('f', {})\nfor i = 1, 3000 do scene:particle { at = vec(i % 50, i // 50, 0), "
      "family = f } end\nscene:interact(f, f, force.pair { cutoff = 2, potential = function(r) return "
      "1 / r end })");
  support::write_file(folder / "test.lua",
                      "for i = 1, 3 do test('one ' .. i, function() open('scene.lua'):advance(0.05) end) end");
  std::vector<std::string> arguments = {command, "--untrusted"};
  if (command == "test") arguments.push_back("test.lua");
  if (command == "run") arguments.insert(arguments.end(), {"scene.lua", "--until", "0.2", "--threads", "8"});
  const support::Finished done = support::use(folder, arguments);
  CHECK(done.err == "");
  CHECK(done.code == 0);
}

TEST_CASE("confine: a stranger's sweep has the table of any other") {
  support::Folder folder;
  support::write_file(folder / "scene.lua",
                      "local n = scene:param('n', 2, { min = 1, max = 9 })\nscene:result('double', 2 * n)\n"
                      "scene:particle { at = vec(n, 0, 0) }");
  const auto sweep = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"sweep", "scene.lua", "--until", "0.1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return support::use(folder, arguments);
  };
  CHECK(sweep({"--set", "n=1:3:3", "--out", "free.csv"}).code == 0);
  CHECK(sweep({"--set", "n=1:3:3", "--out", "held.csv", "--untrusted"}).code == 0);
  CHECK(support::read_file(folder / "held.csv") == support::read_file(folder / "free.csv"));
  CHECK_THAT(sweep({"--set", "n=1:10:10", "--out", "t.csv", "--untrusted"}).err,
             Contains("n must be at most 9, got 10"));
}

TEST_CASE("confine: an untrusted scene runs as any other") {
  const std::string ending = GENERATE(".csv", ".h5", ".xyz", ".glb", ".png");
  support::Folder folder;
  std::filesystem::create_directories(folder.path / "a");
  std::filesystem::create_directories(folder.path / "b");
  support::write_file(folder / "a/helper.lua", "return { height = 2 }");
  support::write_file(folder / "a/scene.lua",
                      "local h = require('helper')\nscene:particle { at = vec(0, h.height, 0) }");
  const auto run = [&](std::vector<std::string> more, const std::string& out) {
    std::vector<std::string> arguments = {"run", "a/scene.lua", "--until", "0.1", "--out", out};
    if (ending == ".png") arguments.insert(arguments.end(), {"--size", "64x64"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return support::use(folder, arguments);
  };
  const support::Finished free = run({}, "free" + ending), held = run({"--untrusted"}, "b/held" + ending);
  CHECK(free.code == held.code);
  CHECK((held.err == free.err || held.err == "pantin: --untrusted: what draws may start any number of threads: the "
                                             "super-user has no limit\n"));
  if (free.code == 0)
    CHECK(support::read_file(folder / ("free" + ending)) == support::read_file(folder / ("b/held" + ending)));
}

TEST_CASE("confine: an untrusted scene writes to what a link leads to, also where that is not there yet") {
  support::Folder folder;
  std::filesystem::create_directory(folder.path / "out");
  std::filesystem::create_symlink("out/table.csv", folder.path / "link.csv");
  support::write_file(folder / "swing.lua", support::swing);
  const support::Finished done =
      support::use(folder, {"run", "--untrusted", "swing.lua", "--until", "0.1", "--out", "link.csv"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK(std::filesystem::is_symlink(folder.path / "link.csv"));
  CHECK(std::filesystem::exists(folder.path / "out" / "table.csv"));
}

TEST_CASE("confine: a film is refused, since another program writes it") {
  const support::Finished done = support::use({}, {"run", "chain", "--untrusted", "--out", "film.mp4"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("--untrusted starts no other program, and film.mp4 needs ffmpeg"));
}

TEST_CASE("confine: memory of a stranger's scene ends at the limit") {
  support::Folder folder;
  support::write_file(folder / "scene.lua", "local t = {}\nfor i = 1, 1e9 do t[i] = { i } end");
  const support::Finished done =
      support::use(folder, {"run", "--untrusted", "scene.lua", "--memory-limit", "64MiB", "--script-limit", "60"});
  CHECK(done.code == 1);
  CHECK_THAT(done.err, Contains("memory"));
}
