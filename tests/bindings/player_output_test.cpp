#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "player/output.hpp"
#include "scene/errors.hpp"

namespace fs = std::filesystem;
using pantin::UsageError;
using pantin::player::Output;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / ("pantin-output-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("output: appears whole, under its own name") {
  Folder folder;
  {
    Output output(folder.path / "a.csv");
    CHECK(output.temporary().ends_with(".csv"));
    output.write("half");
    CHECK_FALSE(fs::exists(folder.path / "a.csv"));
    output.write("whole");
    output.keep();
  }
  CHECK(contents(folder.path / "a.csv") == "whole");
  CHECK(folder.files() == 1);
}

TEST_CASE("output: without keep nothing is left, and an older file stays as it was") {
  Folder folder;
  std::ofstream(folder.path / "a.csv") << "older";
  {
    Output output(folder.path / "a.csv");
    output.write("newer");
  }
  CHECK(contents(folder.path / "a.csv") == "older");
  CHECK(folder.files() == 1);
}

TEST_CASE("output: a link is followed") {
  Folder folder;
  std::ofstream(folder.path / "real.csv") << "older";
  fs::create_symlink("real.csv", folder.path / "link.csv");
  Output output(folder.path / "link.csv");
  output.write("newer");
  output.keep();
  CHECK(fs::is_symlink(folder.path / "link.csv"));
  CHECK(contents(folder.path / "real.csv") == "newer");
}

TEST_CASE("output: a link to what is not there yet is followed, and one that goes round is refused") {
  Folder folder;
  fs::create_symlink("second.csv", folder.path / "first.csv");
  fs::create_symlink(folder.path / "real.csv", folder.path / "second.csv");
  Output output(folder.path / "first.csv");
  output.write("new");
  output.keep();
  CHECK(fs::is_symlink(folder.path / "first.csv"));
  CHECK(fs::is_symlink(folder.path / "second.csv"));
  CHECK(contents(folder.path / "real.csv") == "new");
  fs::create_symlink("round.csv", folder.path / "round.csv");
  CHECK_THROWS_WITH(Output(folder.path / "round.csv"), Catch::Contains("round.csv: Too many levels"));
}

TEST_CASE("output: a place that cannot be written to is known before") {
  Folder folder;
  CHECK_THROWS_AS(Output(folder.path / "missing" / "a.csv"), UsageError);
  CHECK_THROWS_AS(Output(folder.path), UsageError);
  CHECK_THROWS_AS(Output("/proc/a.csv"), UsageError);
  CHECK_THROWS_WITH(Output(folder.path / "missing" / "a.csv"), Catch::Contains("missing/a.csv"));
  CHECK(folder.files() == 0);
}

TEST_CASE("output: a device is written to as it is") {
  Output output("/dev/null");
  CHECK(output.temporary() == "/dev/null");
  output.write("gone");
  output.keep();
  CHECK(fs::is_character_file("/dev/null"));
}
