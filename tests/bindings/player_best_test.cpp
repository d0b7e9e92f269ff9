// `pantin sweep --best`: which values it finds, by how many processes it may, and what cannot be searched.
#include "player/sweep/best.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <sstream>

#include "bindings/program_support.hpp"
#include "player/sweep/cases.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

namespace {

/// Its value is largest, 1, at a = 0.3 and n = 7; it fails where a is above 0.9.
const char* const peak = R"(
local a = scene:param("a", 0.5)
local n = scene:param("n", 3)
if a > 0.9 then error("too much") end
scene:result("noise", math.random())
scene:result("value", 1 - (a - 0.3)^2 - 0.01 * (n - 7)^2)
if scene.seed == 3 then error("three") end
scene:result("word", "rod")
scene:probe("height", function() return a end)
)";

const std::vector<std::string> both = {"--set", "a=0:1", "--set", "n=1:12"};

std::vector<std::string> search(std::vector<std::string> more) {
  std::vector<std::string> arguments = {"sweep", "peak.lua", "--until", "0.01", "--out", "t.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> with(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Finished search_peak(const Folder& folder, const std::vector<std::string>& more) {
  write_file(folder / "peak.lua", peak);
  return use(folder, search(more));
}

std::size_t rows_in(const std::string& table) { return static_cast<std::size_t>(std::ranges::count(table, '\n')); }

/// The number after a text of the output.
double number_after(const std::string& out, const std::string& before) {
  const auto at = out.find(before);
  return at == std::string::npos ? std::nan("") : std::stod(out.substr(at + before.size()));
}

}  // namespace

TEST_CASE("best: it finds the values, rounds whole numbers and writes a row for each case that was run") {
  Folder folder;
  const Finished run = search_peak(folder, with(both, {"--best", "value", "--sample", "150"}));
  CHECK(run.code == 0);
  CHECK(number_after(run.out, "largest value: ") > 0.9999);
  CHECK(number_after(run.out, "--set a=") == Approx(0.3).margin(0.01));
  CHECK_THAT(run.out, Contains("150 cases, ") && Contains(" --set n=7\n"));
  CHECK(rows_in(read_file(folder / "t.csv")) == 151);
  CHECK(folder.files() == std::vector<std::string>{"peak.lua", "t.csv", "t.csv.journal"});
}

TEST_CASE("best: the least of a probe's column") {
  Folder folder;
  const Finished run = search_peak(folder, {"--set", "a=0.1:0.9", "--least", "height last", "--sample", "40"});
  CHECK(run.code == 0);
  CHECK_THAT(run.out, Contains("least height last: 0.1, case") && Contains("--set a=0.1\n"));
}

TEST_CASE("best: the same table by one process, by several, and after each kill") {
  Folder one, three, cut;
  const auto arguments = with(both, {"--best", "value", "--sample", "60", "--seeds", "1:2"});
  REQUIRE(search_peak(one, with(arguments, {"--jobs", "1"})).code == 0);
  CHECK(search_peak(three, with(arguments, {"--jobs", "3"})).code == 0);
  const std::string table = read_file(one / "t.csv");
  CHECK(read_file(three / "t.csv") == table);
  write_file(cut / "peak.lua", peak);
  for (int i = 0; i < 3; i++) {
    Process process(options(search(arguments), cut.path));
    process.wait(0.03 + 0.01 * i);
    process.signal(SIGKILL);
    process.wait(10.0);
  }
  if (!std::filesystem::exists(cut / "t.csv")) REQUIRE(use(cut, search(arguments)).code == 0);
  CHECK(read_file(cut / "t.csv") == table);
  if (!have_program("mpirun")) return;
  Folder ranks;
  write_file(ranks / "peak.lua", peak);
  Process::Options started = options(search(arguments), ranks.path);
  started.arguments.insert(started.arguments.begin(), {"mpirun", "--oversubscribe", "-n", "3"});
  started.environment.insert(started.environment.end(),
                             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  const Finished run = finish(started);
  if (run.err.find("built without MPI") != std::string::npos) return;
  CHECK(read_file(ranks / "t.csv") == table);
}

TEST_CASE("best: of seeds the mean counts, and their cases follow one another") {
  Folder folder;
  const Finished run =
      search_peak(folder, {"--set", "a=0.1:0.8", "--seeds", "5,9,2", "--best", "value", "--sample", "62"});
  CHECK_THAT(run.out, Contains("60 cases, 0") && Contains("the mean of cases "));
  std::istringstream table(read_file(folder / "t.csv"));
  std::string row, value;
  std::getline(table, row);
  for (int i = 0; std::getline(table, row); i++) {
    std::istringstream cells(row);
    std::string number, a, seed;
    std::getline(std::getline(std::getline(cells, number, ','), a, ','), seed, ',');
    CHECK(seed == (i % 3 == 0 ? "5" : i % 3 == 1 ? "9" : "2"));
    CHECK((i % 3 == 0 || a == value));
    value = a;
  }
}

TEST_CASE("best: what is no number to search for is told after a few cases, and leaves nothing") {
  Folder folder;
  const auto refused = [&](const char* name, const char* why) {
    const Finished run = search_peak(folder, with(both, {"--best", name}));
    CHECK(run.code == 2);
    CHECK_THAT(run.err, Contains(why));
    CHECK(folder.files() == std::vector<std::string>{"peak.lua"});
  };
  refused("valeu", "none of the first 8 cases has a number 'valeu'; case 8 has: noise, value, word, height last");
  refused("hash", "has a number 'hash'");
  refused("word", "'word' of case 0 is no number: rod");
}

TEST_CASE("best: a number that some cases do not tell is searched for all the same") {
  Folder folder;
  write_file(folder / "late.lua",
             "local a = scene:param('a', 0.5)\nif a > 0.4 then scene:result('value', -(a - 0.6)^2) end");
  const Finished run =
      use(folder, {"sweep", "late.lua", "--set", "a=0:1", "--best", "value", "--until", "0.01", "--out", "t.csv"});
  CHECK(run.code == 0);
  CHECK(number_after(run.out, "--set a=") == Approx(0.6).margin(0.01));
}

TEST_CASE("best: that the best is at an end of its range is told") {
  Folder folder;
  const Finished end = search_peak(folder, {"--set", "a=0.4:0.8", "--best", "value", "--sample", "60"});
  CHECK_THAT(end.out, Contains("a is at an end of its range, 0.4 to 0.8: there may be better beyond it"));
  const Finished inside =
      search_peak(folder, {"--set", "a=0.1:0.8", "--best", "value", "--sample", "60", "--overwrite"});
  CHECK_THAT(inside.out, !Contains("at an end"));
  const player::Axis over_decades = player::read_axis("a=1e-6:1:log");
  CHECK_FALSE(over_decades.is_near_end("1e-3"));
  CHECK((over_decades.is_near_end("1.001e-6") && over_decades.is_near_end("1")));
  player::Axis whole = player::read_axis("n=1:100000");
  whole.whole = true;
  CHECK((whole.is_near_end("1") && !whole.is_near_end("2")));
}

TEST_CASE("best: what cannot be searched is refused before the first case") {
  Folder folder;
  const auto refused = [&](const std::vector<std::string>& more, const char* why) {
    const Finished run = search_peak(folder, more);
    CHECK(run.code == 2);
    CHECK_THAT(run.err, Contains(why));
    CHECK(folder.files() == std::vector<std::string>{"peak.lua"});
  };
  refused({"--set", "a=0.5", "--best", "value"}, "search ranges");
  refused({"--seeds", "1:5", "--best", "value"}, "search ranges");
  refused({"--set", "a=0:1", "--set", "n=1,2", "--best", "value"}, "n has a list");
  refused({"--set", "a=1:1", "--best", "value"}, "equal ends");
  refused({"--set", "a=0:1", "--best", "value", "--least", "value"}, "--least");
  refused({"--set", "a=0:1", "--best", "value", "--sample", "200000"}, "at most 100000");
  refused({"--set", "a=0:1", "--best", "value", "--sample", "3", "--seeds", "1:5"}, "less than a case for each");
}

TEST_CASE("best: where nothing is found the exit code tells, and all is in the table") {
  Folder folder;
  const Finished failed = search_peak(folder, {"--set", "a=0.91:1", "--best", "value", "--sample", "30"});
  CHECK(failed.code == 1);
  CHECK_THAT(failed.err, Contains("all failed") && Contains("too much"));
  CHECK(rows_in(read_file(folder / "t.csv")) == 31);
  const Finished none =
      search_peak(folder, {"--set", "a=0:0.9", "--best", "value", "--sample", "30", "--seeds", "2:3", "--overwrite"});
  CHECK(none.code == 1);
  CHECK_THAT(none.err, Contains("nothing is best"));
  CHECK_THAT(none.out, Contains("30 cases, 15 of them failed"));
  CHECK(rows_in(read_file(folder / "t.csv")) == 31);
}

TEST_CASE("best: a few whole numbers are each run once") {
  Folder folder;
  const Finished run = search_peak(folder, {"--set", "n=1:12", "--best", "value"});
  CHECK_THAT(run.out, Contains("12 cases, 0") && Contains("--set n=7\n"));
}

TEST_CASE("best: stopped by Ctrl-C, the same command goes on, and another search is refused") {
  Folder folder;
  write_file(folder / "peak.lua", std::string(peak) + "for i = 1, 2e6 do a = a + i end");
  const auto arguments = with(both, {"--best", "value", "--sample", "400"});
  Process process(options(search(arguments), folder.path));
  while (!process.wait(0.005) && rows_in(read_file(folder / "t.csv.journal")) < 10) {}
  process.signal(SIGINT);
  process.wait(10.0);
  REQUIRE(folder.files() == std::vector<std::string>{"peak.lua", "t.csv.journal"});
  const Finished other = use(folder, search(with(both, {"--least", "value", "--sample", "400"})));
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("another sweep"));
}
