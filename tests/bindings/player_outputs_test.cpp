#include <catch2/catch.hpp>

#include "bindings/program_support.hpp"
#include "player/hdf5_table.hpp"

using namespace pantin::support;
namespace player = pantin::player;

namespace {

/// In a shell, where no file may be longer than some kilobytes.
Finished use_with_little_disk(const Folder& folder, const std::string& outputs) {
  Process::Options o = options({}, folder.path);
  o.arguments = {"bash", "-c", "ulimit -f 4; exec \"$0\" run swing.lua --until 1 " + outputs,
                 pantin::sources::program()};
  return finish(o);
}

}  // namespace

TEST_CASE(
    "outputs: what cannot be written whole leaves the file of before, is told by its own name, and fails the run") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  std::vector<std::string> endings = {".csv", ".xyz", ".glb", ".png"};
  if (player::has_hdf5()) endings.emplace_back(".h5");
  if (have_program("ffmpeg")) endings.insert(endings.end(), {".mp4", ".gif", ".webp"});
  for (const std::string& ending : endings) {
    INFO(ending);
    const bool drawn = ending != ".csv" && ending != ".h5" && ending != ".xyz" && ending != ".glb";
    write_file(folder / ("a" + ending), "before");
    const Finished run =
        use_with_little_disk(folder, "--out a" + ending + " --summary s.json" + (drawn ? " --size 320x240" : ""));
    CHECK(run.code == 1);
    CHECK(read_file(folder / ("a" + ending)) == "before");
    CHECK_THAT(run.err, Catch::Contains("a" + ending) && !Catch::Contains(".part"));
    CHECK(folder.files() == std::vector<std::string>{"a" + ending, "s.json", "swing.lua"});
    std::filesystem::remove(folder / ("a" + ending));
    std::filesystem::remove(folder / "s.json");
  }
}

TEST_CASE("outputs: those that are whole are kept where another is not") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  const Finished run = use_with_little_disk(folder, "--out a.xyz --summary s.json");
  CHECK(run.code == 1);
  CHECK(folder.files() == std::vector<std::string>{"s.json", "swing.lua"});
}

TEST_CASE("outputs: a run whose words cannot be written fails") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  Process::Options o = options({}, folder.path);
  o.arguments = {"bash", "-c", "exec \"$0\" run swing.lua --until 0.1 >/dev/full", pantin::sources::program()};
  const Finished run = finish(o);
  CHECK(run.code == 1);
  CHECK_THAT(run.err, Catch::Contains("No space left on device"));
}

TEST_CASE("outputs: names that are no UTF-8 lose nothing") {
  Folder folder;
  write_file(folder / "odd.lua",
             "scene.title = '\\xff' scene:ball { radius = 1, density = 1, name = '\\xed\\xa0\\x80' }"
             "scene:result('\\xfe', '\\xfe')");
  const Finished run =
      use(folder, {"run", "odd.lua", "--until", "0.1", "--out", "a.glb", "--out", "a.csv", "--summary", "s.json"});
  CHECK(run.code == 0);
  CHECK(folder.files() == std::vector<std::string>{"a.csv", "a.glb", "odd.lua", "s.json"});
  CHECK_THAT(read_file(folder / "a.glb"), Catch::Contains("\\\\xff") && Catch::Contains("\\\\xed\\\\xa0\\\\x80"));
}

TEST_CASE("outputs: what is read is not written, by no name of it, and no file twice") {
  Folder folder;
  const std::string scene = swing + std::string("print 'opened'");
  write_file(folder / "in.lua", scene);
  write_file(folder / "a.csv", "before");
  write_file(folder / "lib.lua", scene);
  REQUIRE(use(folder, {"run", "in.lua", "--until", "0.1", "--save-at", "0.05", "--save-to", "in.pantin"}).code == 0);
  const std::string state = read_file(folder / "in.pantin");
  std::filesystem::create_symlink("in.lua", folder.path / "in.csv");
  std::filesystem::create_hard_link(folder.path / "in.lua", folder.path / "in.json");
  std::filesystem::create_symlink("a.csv", folder.path / "b.csv");
  std::filesystem::create_symlink("new.csv", folder.path / "c.csv");
  std::filesystem::create_symlink("lib.lua", folder.path / "lib.csv");
  std::filesystem::create_symlink("lib.lua", folder.path / "lib.svg");
  std::filesystem::create_symlink("lib.lua", folder.path / "lib.pantin");
  const auto before = folder.files();
  const std::vector<std::vector<std::string>> uses = {
      {"run", "in.lua", "--summary", "in.lua"},
      {"run", "in.lua", "--summary", "in.json"},
      {"run", "in.lua", "--out", "in.csv"},
      {"run", "in.lua", "--save-at", "0.05", "--save-to", "./in.lua"},
      {"run", "--from", "in.pantin", "--until", "0.2", "--summary", "in.pantin"},
      {"run", "in.lua", "--out", "a.csv", "--summary", "b.csv"},
      {"run", "in.lua", "--out", "c.csv", "--summary", "new.csv"},
      {"play", "in.lua", "--record", "in.lua", "--until", "0.1"},
      {"play", "in.lua", "--record", "x", "--summary", "./x", "--until", "0.1"},
      {"sweep", "in.lua", "--set", "mass=1,2", "--out", "in.csv"},
      {"plot", "a.csv", "--x", "time", "--y", "height", "--out", "b.csv"},
      {"run", "in.lua", "--summary", "lib.lua"},
      {"run", "in.lua", "--save-at", "0.05", "--save-to", "lib.lua"},
      {"run", "in.lua", "--out", "lib.csv"},
      {"play", "in.lua", "--record", "lib.lua", "--until", "0.1"},
      {"report", "in.lua", "--out", "lib"},
      {"sweep", "in.lua", "--set", "mass=1,2", "--out", "lib.csv"},
      {"plot", "a.csv", "--x", "time", "--y", "height", "--out", "lib.svg"},
      {"lammps", "in.lua", "--out", "lib.pantin", "--overwrite"},
      {"run", "in.lua", "--summary", ""},
      {"run", "in.lua", "--save-at", "0.05", "--save-to", ""},
      {"play", "in.lua", "--record", "", "--until", "0.1"},
      {"report", "in.lua", "--out", ""},
      {"export", "in.lua", "--lammps", ""},
      {"lammps", "in.lua", "--folder", ""},
  };
  for (const auto& arguments : uses) {
    const Finished done = use(folder, arguments);
    INFO(arguments[0] << " " << arguments.back() << ": " << done.err);
    CHECK(done.code != 0);
    CHECK(done.out == "");
    CHECK(folder.files() == before);
    CHECK(read_file(folder / "in.lua") == scene);
    CHECK(read_file(folder / "lib.lua") == scene);
    CHECK(read_file(folder / "in.pantin") == state);
    CHECK(read_file(folder / "a.csv") == "before");
  }
}

TEST_CASE("outputs: a picture is written to a device as it is, and to what a link leads to") {
  Folder folder;
  write_file(folder / "swing.lua", swing);
  std::filesystem::create_symlink("/dev/full", folder.path / "full.png");
  std::filesystem::create_symlink("real.png", folder.path / "link.png");
  const std::string long_name = std::string(231, 'a') + ".png";
  const std::vector<std::string> run = {"run", "swing.lua", "--until", "0.1", "--size", "320x240", "--out"};
  const auto write = [&](const std::string& file) {
    std::vector<std::string> arguments = run;
    arguments.push_back(file);
    return use(folder, arguments);
  };
  const Finished full = write("full.png");
  CHECK(full.code == 1);
  CHECK_THAT(full.err, Catch::Contains("full.png") && Catch::Contains("No space left on device"));
  CHECK(std::filesystem::is_character_file(folder.path / "full.png"));
  CHECK(write("link.png").code == 0);
  CHECK(std::filesystem::is_symlink(folder.path / "link.png"));
  CHECK(std::filesystem::is_regular_file(folder.path / "real.png"));
  CHECK(write(long_name).code == 0);
  CHECK(folder.files() == std::vector<std::string>{long_name, "full.png", "link.png", "real.png", "swing.lua"});
}
