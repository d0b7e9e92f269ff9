// Each call into the system fails once, for each kind of output: tests/preload/faults.cpp.
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "bindings/program_support.hpp"
#include "player/hdf5_table.hpp"

namespace {

using namespace pantin;

struct Outcome {
  support::Finished finished;
  std::string file;            ///< its content; empty: there is none
  std::set<std::string> left;  ///< other files
  long failed = 0, calls = 0;  ///< whether a call failed; of that kind
  std::string text() const { return "code " + std::to_string(finished.code) + ", told:\n" + finished.err; }
};

std::vector<std::string> arguments_for(const std::string& file) {
  std::vector<std::string> all = {"run", "scene.lua", "--until", "0.1"};
  if (file.ends_with(".json"))
    all.insert(all.end(), {"--summary", file});
  else if (file.ends_with(".pantin"))
    all.insert(all.end(), {"--save-at", "0.05", "--save-to", file});
  else
    all.insert(all.end(), {"--out", file});
  for (const char* drawn : {".png", ".mp4", ".gif"})
    if (file.ends_with(drawn)) all.insert(all.end(), {"--size", "64x64"});
  return all;
}

Outcome run_with(const std::string& file, const std::string& fault, const std::string& old) {
  const support::Folder folder;
  support::write_file(folder / "scene.lua", support::swing);
  if (!old.empty()) support::write_file(folder / file, old);
  support::Process::Options options = support::options(arguments_for(file), folder.path);
  options.environment.insert(
      options.environment.end(),
      {"LD_PRELOAD=" + sources::preload("faults"), "PANTIN_FAULT=" + fault, "PANTIN_FAULT_TOLD=" + (folder / "told")});
  Outcome outcome;
  outcome.finished = support::finish(options);
  for (const std::string& name : folder.files()) {
    if (name == file)
      outcome.file = support::read_file(folder / name);
    else if (name == "told")
      std::istringstream(support::read_file(folder / name)) >> outcome.failed >> outcome.calls;
    else if (name != "scene.lua")
      outcome.left.insert(name);
  }
  return outcome;
}

/// Of what holds times of this machine the length, or its end, tells.
bool is_whole(const std::string& file, const std::string& content, const std::string& good) {
  if (file.ends_with(".json")) return content.size() > 2 && content.starts_with("{") && content.ends_with("}\n");
  if (file.ends_with(".pantin")) return content.size() == good.size();
  return content == good;
}

/// What holds of each end: the file is whole, or is what it was; the exit code tells; nothing hidden is left or named.
void check_outcome(const std::string& file, const Outcome& outcome, const std::string& old, const std::string& good) {
  const bool whole = is_whole(file, outcome.file, good), no_memory = outcome.finished.code == 128 + 6;
  CHECK((whole || outcome.file == old));
  if (outcome.finished.code == 0) {
    CHECK(whole);
  } else {
    CHECK((outcome.finished.code == 1 || outcome.finished.code == 2 || no_memory));
    CHECK(outcome.finished.err != "");
    CHECK(outcome.finished.err.find(".part") == std::string::npos);
  }
  CHECK(outcome.left == std::set<std::string>());
}

/// All of a few; of many the first, and some of the rest.
std::vector<long> places(long calls) {
  std::vector<long> chosen;
  for (long n = 1; n <= calls; n += 1 + n / 40) chosen.push_back(n);
  return chosen;
}

void fail_each(const std::string& file, std::initializer_list<const char*> kinds) {
  if (sources::preload("faults").empty()) return;
  const std::string good = run_with(file, "none:0", "").file;
  REQUIRE(good != "");
  for (const std::string kind : kinds) {
    const Outcome first = run_with(file, kind + ":0", "");
    REQUIRE(first.finished.code == 0);
    for (const long n : places(first.calls)) {
      const std::string old = n % 2 == 0 ? "old" : "";
      const Outcome outcome = run_with(file, kind + ":" + std::to_string(n), old);
      INFO(file << ", " << kind << " " << n << " of " << first.calls << ": " << outcome.text());
      check_outcome(file, outcome, old, good);
    }
  }
}

}  // namespace

TEST_CASE("faults: a file that cannot be opened, written, closed, flushed or renamed is whole or what it was") {
  const std::string ending = GENERATE(".csv", ".h5", ".xyz", ".glb", ".json", ".pantin");
  if (ending == ".h5" && !player::has_hdf5()) return;
  fail_each("out" + ending, {"open", "write", "close", "rename", "fsync"});
}

TEST_CASE("faults: the same of pictures and films, and of the program that writes these", "[slow]") {
  const std::string ending = GENERATE(".png", ".mp4", ".gif");
  if (!run_with("out" + ending, "none:0", "").file.empty())
    fail_each("out" + ending, {"open", "write", "close", "rename", "fsync", "fork"});
}

TEST_CASE("faults: where memory ends, a file is whole or what it was", "[slow]") {
  const std::string ending = GENERATE(".csv", ".xyz", ".glb", ".json", ".pantin");
  fail_each("out" + ending, {"malloc"});
}
