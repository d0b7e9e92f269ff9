// `pantin sweep`: cases, table, journal, and processes that die.
#include "player/sweep/sweep.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <map>
#include <sstream>
#include <thread>

#include "bindings/program_support.hpp"
#include "player/sweep/bundle.hpp"
#include "player/sweep/cases.hpp"
#include "player/sweep/course.hpp"
#include "player/sweep/foreman.hpp"
#include "player/sweep/journal.hpp"
#include "player/sweep/workers.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

namespace {

const char* const pendulum = R"(
local length = scene:param("length", 1.0, { min = 0.1, max = 10 })
local links = scene:param("links", 3)
local bob = scene:particle { at = vec(length, 0, 0), mass = 1 }
scene:rod(bob, vec(0, 0, 0))
scene:probe("height", function() return bob.position.y end)
scene:result("noise", math.random())
if length > 4.5 then error("too long") end
)";

std::vector<std::string> values_of(const player::Axis& axis) {
  std::vector<std::string> values;
  for (std::uint64_t i = 0; i < axis.size(); i++) values.push_back(axis.value(i));
  return values;
}

std::vector<std::string> rows_of(const std::string& table) {
  std::vector<std::string> rows;
  std::istringstream in(table);
  for (std::string row; std::getline(in, row);) rows.push_back(row);
  return rows;
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<int> children_of(int process) {
  const std::string id = std::to_string(process);
  std::istringstream in(read_file("/proc/" + id + "/task/" + id + "/children"));
  std::vector<int> all;
  for (int child = 0; in >> child;) all.push_back(child);
  return all;
}

/// A sweep in a folder that has the pendulum, into t.csv.
Finished sweep_pendulum(const Folder& folder, std::vector<std::string> more) {
  write_file(folder / "pendulum.lua", pendulum);
  std::vector<std::string> arguments = {"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return use(folder, arguments);
}

const std::vector<std::string> grid = {"--set", "length=1:4:4", "--set", "links=2,3", "--seeds", "1:5"};

}  // namespace

TEST_CASE("sweep: a range has both its ends and is even, in the logarithm too; a list is as it is") {
  CHECK(values_of(player::read_axis("a=1:2:5")) == std::vector<std::string>{"1", "1.25", "1.5", "1.75", "2"});
  CHECK(values_of(player::read_axis("a=1:1e4:3:log")) == std::vector<std::string>{"1", "100", "10000"});
  CHECK(values_of(player::read_axis("a=1e-300:1e300:3:log")) == std::vector<std::string>{"1e-300", "1", "1e+300"});
  CHECK(values_of(player::read_axis("a=700000:900000:3")) == std::vector<std::string>{"700000", "800000", "900000"});
  CHECK(values_of(player::read_axis("a=3:1:3")) == std::vector<std::string>{"3", "2", "1"});
  CHECK(values_of(player::read_axis("kind=rod,string")) == std::vector<std::string>{"rod", "string"});
  CHECK(values_of(player::read_axis("kind=\"c,d\",e,\"a:b\"")) == std::vector<std::string>{"c,d", "e", "a:b"});
  CHECK(values_of(player::read_axis("kind=a\"b,c")) == std::vector<std::string>{"a\"b", "c"});
  CHECK(values_of(player::read_axis("scene.step=1/60")) == std::vector<std::string>{"1/60"});
  CHECK(values_of(player::read_seeds("3:5")) == std::vector<std::string>{"3", "4", "5"});
}

TEST_CASE("sweep: values that are none are refused before anything runs") {
  for (const char* bad : {"a", "=1", "a=1:2:1", "a=1:2:x", "a=1:inf:3", "a=0:1:3:log", "a=1,,2", "a=1:2:3:4",
                          "a=1:2:2.5", "a=\"b,c", "a=\"b\"c"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(player::read_axis(bad), UsageError);
  }
  CHECK_THROWS_WITH(player::read_axis("a=2,1/2,x,0.5"), Contains("--set a=2,1/2,x,0.5 has 0.5 twice"));
  CHECK_THROWS_WITH(player::read_axis("a=x,y,x"), Contains("has x twice"));
  CHECK_THROWS_WITH(player::read_seeds("1,1,3"), Contains("--seeds 1,1,3 has 1 twice"));
  for (const char* bad : {"5:1", "x", "1:", "-1", "1.5"}) CHECK_THROWS_AS(player::read_seeds(bad), UsageError);
  using player::Cases, player::read_axis;
  CHECK_THROWS_WITH(Cases({read_axis("a=0:1:1000000"), read_axis("b=0:1:1000000")}, 0), Contains("1e+12 cases"));
  CHECK_THROWS_WITH(Cases({read_axis("a=0:1")}, 0), Contains("has no count"));
  for (const char* many : {"a=1:2:1e12", "a=1:2:1e300"})
    CHECK_THROWS_WITH(Cases({read_axis(many)}, 0), Contains("cases are more than the"));
}

TEST_CASE("sweep: a Latin hypercube has each of its strips once") {
  const player::Cases cases({player::read_axis("a=0:1"), player::read_axis("b=10:20")}, 100);
  std::vector<int> strips_a(100), strips_b(100);
  for (std::uint64_t i = 0; i < cases.count(); i++) {
    const auto set = cases.settings(i);
    strips_a[static_cast<std::size_t>(100 * std::stod(set[0].second))]++;
    strips_b[static_cast<std::size_t>(10 * (std::stod(set[1].second) - 10))]++;
  }
  CHECK(strips_a == std::vector<int>(100, 1));
  CHECK(strips_b == std::vector<int>(100, 1));
}

TEST_CASE("sweep: the table has a row a case, the same by one process and by several") {
  Folder one, three;
  auto arguments = grid;
  arguments.insert(arguments.end(), {"--jobs", "1"});
  const Finished first = sweep_pendulum(one, arguments);
  CHECK(first.code == 0);
  CHECK(first.out == "40 cases, 0 of them failed: t.csv\n");
  arguments.back() = "3";
  CHECK(sweep_pendulum(three, arguments).code == 0);
  const std::string table = read_file(one / "t.csv");
  CHECK(table == read_file(three / "t.csv"));
  CHECK(one.files() == std::vector<std::string>{"pendulum.lua", "t.csv", "t.csv.journal"});
  const auto rows = rows_of(table);
  REQUIRE(rows.size() == 41);
  CHECK_THAT(rows[0], Contains("case,length,links,scene.seed,noise,height last,height least,height largest,time"));
  CHECK_THAT(rows[1], Contains("0,1,2,1,"));
  CHECK_THAT(rows[40], Contains("39,4,3,5,"));
  CHECK(rows[1] != rows[2]);  // by another seed
}

TEST_CASE("sweep: a case that fails is a row with its error, and the others have theirs") {
  Folder folder;
  const Finished run = sweep_pendulum(folder, {"--set", "length=4,5"});
  CHECK(run.code == 0);
  CHECK(run.out == "2 cases, 1 of them failed: t.csv\n");
  const auto rows = rows_of(read_file(folder / "t.csv"));
  CHECK_THAT(rows.at(2), Contains("pendulum.lua:8: too long"));
}

TEST_CASE("sweep: what is wrong is told before the first case, and leaves nothing") {
  Folder folder;
  const auto refused = [&](std::vector<std::string> more, const char* why) {
    const Finished run = sweep_pendulum(folder, std::move(more));
    CHECK(run.code == 2);
    CHECK_THAT(run.err, Contains(why));
    CHECK(folder.files() == std::vector<std::string>{"pendulum.lua"});
  };
  refused({}, "needs --set");
  refused({"--set", "mass=1,2"}, "no parameter 'mass'");
  refused({"--set", "mass=1:2:3"}, "no parameter 'mass'");
  refused({"--set", "lenght=1:2:3"}, "Did you mean 'length'?");
  refused({"--seeds", "5:1"}, "pantin: --seeds: the first comes before the last, 1:5, not 5:1");
  refused({"--what", "1", "--every", "0.1", "--reduce=mean"},
          "not understood: --what 1 --every 0.1 --reduce=mean (--every is of play, run; --reduce is of play, run");
  refused({"--set", "length=1,2", "--set", "length=3"}, "set twice");
  refused({"--set", "links=1:3:9"}, "a whole number in this scene");
  refused({"--set", "length=1:2:1000000", "--seeds", "1:1000000"}, "1e+12 cases");
  refused({"--set", "length=1:11:3"}, "length must be at most 10, got 11");
  refused({"--set", "length=0.05,1"}, "length must be at least 0.1, got 0.05");
  refused({"--set", "links=2,many"}, "--set links=many: links must be a number, got 'many'");
  refused({"--set", "scene.stepp=0.01:0.02:3"}, "Did you mean 'step'?");
}

TEST_CASE("sweep: a value that is none of a parameter's choices is refused before the first case") {
  Folder folder;
  write_file(folder / "kinds.lua", "scene:param('kind', 'red', { choices = { 'red', 'blue' } })");
  const auto of = [&](const char* kinds) {
    return use(folder, {"sweep", "kinds.lua", "--set", kinds, "--until", "0.01", "--out", "t.csv"});
  };
  const Finished wrong = of("kind=red,green");
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, Contains("--set kind=green: kind must be one of red, blue, got green"));
  CHECK(of("kind=red,blue").code == 0);
}

TEST_CASE("sweep: a state, whose parameters are set, is refused") {
  Folder folder;
  write_file(folder / "late.pantin", "");
  const Finished run = use(folder, {"sweep", "late.pantin", "--set", "a=1,2", "--out", "t.csv"});
  CHECK(run.code == 2);
  CHECK_THAT(run.err, Contains("late.pantin is a state") && Contains("a sweep opens a scene"));
}

TEST_CASE("sweep: killed at any moment it goes on, and comes to the same table") {
  Folder whole, cut;
  REQUIRE(sweep_pendulum(whole, grid).code == 0);
  write_file(cut / "pendulum.lua", pendulum);
  auto arguments = std::vector<std::string>{"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv"};
  arguments.insert(arguments.end(), grid.begin(), grid.end());
  for (int i = 0; i < 3; i++) {
    Process process(options(arguments, cut.path));
    process.wait(0.02 + 0.01 * i);
    process.signal(SIGKILL);
    process.wait(10.0);
  }
  if (!std::filesystem::exists(cut / "t.csv")) REQUIRE(use(cut, arguments).code == 0);
  CHECK(read_file(cut / "t.csv") == read_file(whole / "t.csv"));
}

TEST_CASE("sweep: a journal that was cut off goes on; one of another sweep, or changed by hand, is refused") {
  Folder folder;
  const std::string table = folder / "t.csv", path = table + ".journal";
  const player::CaseRow row = {7, {{"a", "1"}}, {{"error", "x"}}, {}};
  { player::Journal(table, "one").add(row); }
  const std::string content = read_file(path);
  write_file(path, content + "0123");
  CHECK(player::Journal(table, "one").rows().at(7).told == row.told);
  CHECK(read_file(path) == content);
  for (const bool overwrite : {false, true})
    CHECK_THROWS_WITH(player::Journal(table, "two", {false, overwrite}), Contains("another sweep"));
  std::string changed = content;
  changed[changed.find("\"1\"") + 1] = '2';
  write_file(path, changed);
  CHECK_THROWS_WITH(player::Journal(table, "one"), Contains(", line 2: this line was changed"));
}

TEST_CASE("sweep: two into one table are refused") {
  Folder folder;
  const std::string table = folder / "t.csv";
  const player::Journal first(table, "one");
  CHECK_THROWS_WITH(player::Journal(table, "one"),
                    Contains("another sweep is writing") && Contains("wait until they have"));
}

TEST_CASE("sweep: one that is finished is not done again, and its table is written again where it is gone") {
  Folder folder;
  const std::vector<std::string> lengths = {"--set", "length=4,5"};
  const Finished first = sweep_pendulum(folder, lengths);
  const std::string table = read_file(folder / "t.csv"), journal = read_file(folder / "t.csv.journal");
  const Finished again = sweep_pendulum(folder, lengths);
  CHECK((again.code == 0 && again.out == first.out));
  CHECK_THAT(again.err, Contains("nothing is left to do") && Contains("--retry-failed"));
  CHECK(read_file(folder / "t.csv.journal") == journal);
  std::filesystem::remove(folder / "t.csv");
  CHECK(sweep_pendulum(folder, lengths).code == 0);
  CHECK(read_file(folder / "t.csv") == table);
}

TEST_CASE("sweep: a table that is there is lost with --overwrite alone, whoever made it") {
  Folder folder;
  REQUIRE(sweep_pendulum(folder, {"--set", "length=1,2"}).code == 0);
  const std::string first = read_file(folder / "t.csv");
  const auto refused = [&](const char* lengths, const char* why) {
    const Finished run = sweep_pendulum(folder, {"--set", lengths});
    CHECK(run.code == 2);
    CHECK_THAT(run.err, Contains(why) && Contains("--overwrite"));
    CHECK(read_file(folder / "t.csv") == first);
  };
  refused("length=1,2,3", "of another sweep");
  std::filesystem::remove(folder / "t.csv.journal");
  refused("length=1,2", "t.csv is there already");
  CHECK(folder.files() == std::vector<std::string>{"pendulum.lua", "t.csv"});
  write_file(folder / "t.csv", first + "a note\n");
  CHECK(sweep_pendulum(folder, {"--set", "length=1,2"}).code == 2);
  CHECK(read_file(folder / "t.csv") == first + "a note\n");
  CHECK(sweep_pendulum(folder, {"--set", "length=1,2", "--overwrite"}).code == 0);
  CHECK(read_file(folder / "t.csv") == first);
}

TEST_CASE("sweep: where cases failed, neither the table nor its journal is lost without a word") {
  Folder folder;
  REQUIRE(sweep_pendulum(folder, {"--set", "length=4,5"}).code == 0);
  const std::string table = read_file(folder / "t.csv"), journal = read_file(folder / "t.csv.journal");
  CHECK_THAT(sweep_pendulum(folder, {"--set", "length=1,2"}).err,
             Contains("t.csv.journal is of another sweep") && Contains("--overwrite"));
  CHECK(read_file(folder / "t.csv") == table);
  CHECK(read_file(folder / "t.csv.journal") == journal);
  write_file(folder / "t.csv", table + "a note\n");
  const Finished altered = sweep_pendulum(folder, {"--set", "length=4,5", "--retry-failed"});
  CHECK(altered.code == 2);
  CHECK_THAT(altered.err, Contains("t.csv was changed since this sweep wrote it"));
  CHECK(read_file(folder / "t.csv") == table + "a note\n");
  write_file(folder / "t.csv", "");
  CHECK_THAT(sweep_pendulum(folder, {"--set", "length=4,5"}).err,
             Contains("t.csv was changed since this sweep wrote it"));
  CHECK(sweep_pendulum(folder, {"--set", "length=4,5", "--retry-failed", "--overwrite"}).code == 0);
  CHECK(read_file(folder / "t.csv") == table);
}

TEST_CASE("sweep: a table that came while it ran stays, and once that is moved the rows are written") {
  Folder folder;
  const std::string table = folder / "t.csv";
  player::Journal journal(table, "one");
  journal.add({0, {{"a", "1"}}, {}, {}});
  write_file(table, "mine");
  CHECK_THROWS_WITH(journal.check_table(),
                    Contains("is there already") && Contains("move it away and start again, what is done is kept"));
  std::filesystem::remove(table);
  journal.check_table();
  journal.finish([&] { write_file(table, "theirs"); }, "theirs");
  journal.check_table();
}

TEST_CASE("sweep: what a stopped one has done is kept by --overwrite, of the same scene alone") {
  Folder folder;
  const std::string table = folder / "t.csv";
  { player::Journal(table, "one").add({0, {{"a", "1"}}, {}, {}}); }
  write_file(table, "mine");
  CHECK_THROWS_WITH(player::Journal(table, "one"), Contains("what is done is kept"));
  CHECK(player::Journal(table, "one", {false, true}).rows().size() == 1);
  CHECK_THROWS_WITH(player::Journal(table, "two", {false, true}), Contains("delete the file to begin the sweep anew"));
}

TEST_CASE("sweep: a table for which there is no space is told to be written again from its journal") {
  Folder folder;
  const std::vector<std::string> lengths = {"--set", "length=1,2"};
  REQUIRE(sweep_pendulum(folder, lengths).code == 0);
  std::filesystem::remove(folder / "t.csv");
  Process::Options full = options({"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv"}, folder.path);
  full.arguments.insert(full.arguments.begin(),
                        {"sh", "-c", "{ (ulimit -f 0; exec \"$@\"); echo code $?; } 2>&1 | cat", "sh"});
  full.arguments.insert(full.arguments.end(), lengths.begin(), lengths.end());
  CHECK_THAT(finish(full).out,
             Contains("t.csv.journal, and the same command writes the table from it once it can\ncode 1"));
  CHECK(sweep_pendulum(folder, lengths).code == 0);
  CHECK(rows_of(read_file(folder / "t.csv")).size() == 3);
}

TEST_CASE("sweep: results come before probes in the table, whichever case is the first to tell any") {
  Folder folder;
  write_file(folder / "late.lua", R"(
    local v = scene:param("v", 1)
    scene:probe("x", function() return 7 end)
    if v > 1 then scene:result("r" .. v, v) end
  )");
  REQUIRE(use(folder, {"sweep", "late.lua", "--set", "v=1,3,2", "--until", "0.01", "--out", "t.csv"}).code == 0);
  const auto rows = rows_of(read_file(folder / "t.csv"));
  CHECK_THAT(rows.at(0), Contains("case,v,r3,r2,x last,x least,x largest,time"));
  CHECK_THAT(rows.at(1), Contains("0,1,,,7,7,7,"));
  CHECK_THAT(rows.at(3), Contains("2,2,,2,7,7,7,"));
}

TEST_CASE("sweep: without a terminal a line tells now and then how far it is", "[slow]") {
  Folder folder;
  write_file(folder / "slow.lua", "local v = scene:param('v', 1) for i = 1, 1e8 do v = v + i end");
  const Finished run = use(folder, {"sweep", "slow.lua", "--seeds", "1:100000", "--sample", "40", "--until", "0.01",
                                    "--jobs", "1", "--out", "t.csv", "--script-limit", "100"});
  INFO(run.err);
  CHECK(run.code == 0);
  CHECK_THAT(run.err, Contains("pantin: ") && Contains(" of 40 cases, 0 failed, ") && Contains("s left\n"));
  CHECK(lines(run.err) <= 11);
}

TEST_CASE("sweep: processes that mpirun starts come to the same table, or are told that there is no MPI") {
  if (!have_program("mpirun")) return;
  Folder one, three;
  REQUIRE(sweep_pendulum(one, grid).code == 0);
  write_file(three / "pendulum.lua", pendulum);
  Process::Options started = options({"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv"}, three.path);
  started.arguments.insert(started.arguments.begin(), {"mpirun", "--oversubscribe", "-n", "3"});
  started.arguments.insert(started.arguments.end(), grid.begin(), grid.end());
  started.environment.insert(started.environment.end(),
                             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  const Finished run = finish(started);
  if (run.err.find("built without MPI") != std::string::npos) return;
  CHECK(run.code == 0);
  CHECK(read_file(three / "t.csv") == read_file(one / "t.csv"));
}

TEST_CASE("sweep: what is wrong is told by the first of several processes alone") {
  if (!have_program("mpirun")) return;
  Folder folder;
  write_file(folder / "pendulum.lua", pendulum);
  Process::Options started = options({"sweep", "pendulum.lua", "--set", "mass=1,2", "--out", "t.csv"}, folder.path);
  started.arguments.insert(started.arguments.begin(), {"mpirun", "--oversubscribe", "-n", "3"});
  started.environment.insert(started.environment.end(),
                             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  const Finished run = finish(started);
  const std::size_t at = run.err.find("no parameter 'mass'");
  CHECK(at != std::string::npos);
  CHECK(run.err.find("no parameter 'mass'", at + 1) == std::string::npos);
}

TEST_CASE("sweep: where a rank loses the process that runs its cases all end, and the same command goes on") {
  if (!have_program("mpirun")) return;
  Folder folder, whole;
  write_file(folder / "slow.lua", "for i = 1, scene:param('n', 1) * 3e6 do math.sqrt(i) end");
  std::vector<std::string> sweep = {"sweep", "slow.lua", "--set", "n=1:10:10", "--until", "0.1", "--out", "t.csv"};
  Process::Options started = options(sweep, folder.path);
  started.arguments.insert(started.arguments.begin(), {"mpirun", "--oversubscribe", "-n", "2"});
  started.environment.insert(started.environment.end(),
                             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  Process run(started);
  std::vector<int> runners;
  for (int i = 0; i < 200 && runners.empty() && !run.wait(0.05); i++)
    for (const int rank : children_of(run.id()))
      for (const int foreman : children_of(rank))
        if (!children_of(foreman).empty()) runners.push_back(foreman);
  if (runners.empty()) return;  // built without MPI
  for (const int runner : runners) kill(runner, SIGKILL);
  CHECK(run.wait(60.0).value_or(0) != 0);
  CHECK_THAT(run.err(), Contains("the process that runs cases is gone: the same command goes on"));
  CHECK(use(folder, sweep).code == 0);
  write_file(whole / "slow.lua", read_file(folder / "slow.lua"));
  CHECK(use(whole, sweep).code == 0);
  CHECK(read_file(folder / "t.csv") == read_file(whole / "t.csv"));
}

TEST_CASE("sweep: what waits behind a long case is done by a rank that is idle") {
  if (!have_program("mpirun")) return;
  Folder folder;
  write_file(folder / "long.lua", "if scene:param('n', 1) == 393 then while true do end end");
  Process::Options started = options(
      {"sweep", "long.lua", "--set", "n=1:400:400", "--until", "0.01", "--out", "t.csv", "--script-limit", "1000"},
      folder.path);
  started.arguments.insert(started.arguments.begin(), {"mpirun", "--oversubscribe", "-n", "3"});
  started.environment.insert(started.environment.end(),
                             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"});
  Process run(started);
  std::size_t lines = 0;  // of the journal: its head, and a row each
  for (int i = 0; i < 600 && lines < 400 && !run.wait(0.1); i++)
    lines = rows_of(read_file(folder / "t.csv.journal")).size();
  if (run.err().find("built without MPI") != std::string::npos) return;
  CHECK(lines == 400);
  for (const int rank : children_of(run.id())) kill(rank, SIGTERM);
  CHECK(run.wait(60.0).has_value());
}

TEST_CASE("sweep: processes that srun starts without MPI are told, and none runs all cases for itself") {
  Folder folder;
  write_file(folder / "pendulum.lua", pendulum);
  Process::Options alone = options({"sweep", "pendulum.lua", "--set", "length=1,2", "--out", "t.csv"}, folder.path);
  alone.environment.emplace_back("SLURM_STEP_NUM_TASKS=4");
  const Finished run = finish(alone);
  CHECK(run.code == 2);
  CHECK_THAT(run.err, Contains("srun started 4 processes") && Contains("--mpi=pmix"));
  CHECK(folder.files() == std::vector<std::string>{"pendulum.lua"});
}

TEST_CASE("sweep: what dies of a rank's work is told, and takes neither it nor what comes after") {
  const auto work = [](const std::string& piece) {
    if (piece == "die") raise(SIGKILL);
    return "did " + piece;
  };
  const player::Foreman foreman(work,
                                [](const std::string& piece, const std::string& how) { return piece + ": " + how; });
  CHECK(foreman.result_of("one") == "did one");
  CHECK_THAT(foreman.result_of("die"), Contains("die: its process was ended by signal 9"));
  CHECK(foreman.result_of("two") == "did two");
}

TEST_CASE("sweep: of a bundle the cases that do not begin in time are left to whoever asks next") {
  const player::Bundle bundle = {{3, {{"a", "1"}}}, {4, {{"a", "two\nlines"}, {"b", ""}}}, {5, {}}};
  const auto run = [](const player::CaseOrder& order) {
    if (order.number == 4) std::this_thread::sleep_for(std::chrono::duration<double>(1.1 * player::bundle_time));
    return player::CaseRow{order.number, {}, {{"time", order.set.empty() ? "none" : order.set[0].second}}, {}};
  };
  const player::BundleResult result = player::result_of(player::run_bundle(text_of(bundle), run));
  CHECK(result.seconds > player::bundle_time);
  REQUIRE(result.rows.size() == 2);
  CHECK(result.rows[1].number == 4);
  CHECK(result.rows[1].measured == player::Cells{{"time", "two\nlines"}});
  REQUIRE(result.left.size() == 1);
  CHECK(result.left[0].number == 5);
}

TEST_CASE("sweep: of many short cases those whose process ends are rows, and each of the others has its own") {
  const Folder folder;
  const player::Cases cases({player::read_axis("a=1:200:200")}, 0);
  player::Journal journal(folder / "t.csv", "a sweep");
  const auto run = [](const player::CaseOrder& order) {
    if (order.number == 77 || order.number == 78 || order.number == 199) raise(SIGKILL);
    return player::CaseRow{order.number, order.set, {}, {}};
  };
  player::Course course(cases, journal, nullptr, 2);
  player::Workers workers(2, [&](const std::string& bundle) { return player::run_bundle(bundle, run); });
  int shared = 0;
  const bool all = workers.run(
      [&] {
        shared++;
        return course.next();
      },
      [&](const std::string& result) { course.keep(result); },
      [&](const std::string& bundle, const std::string& how) { course.keep(player::result_of_dead(bundle, how)); });
  CHECK(all);
  CHECK(shared < 150);
  REQUIRE(journal.rows().size() == 200);
  for (const auto& [number, row] : journal.rows()) {
    CAPTURE(number);
    CHECK(failed(row) == (number == 77 || number == 78 || number == 199));
    if (!failed(row)) CHECK(row.told == cases.settings(number));
  }
}

TEST_CASE("sweep: a case that does not come back, or takes all memory, is stopped in its process, too") {
  Folder folder;
  write_file(folder / "bad.lua", R"(
    local kind = scene:param("kind", "fine")
    if kind == "load" then while true do end end
    scene:on("step", function()
      if kind == "step" then while true do end end
      if kind == "memory" then while true do scene:particle {} end end
    end)
    scene:probe("one", function() return 1 end)
  )");
  const Finished run = use(folder, {"sweep", "bad.lua", "--set", "kind=fine,load,step,memory", "--until", "0.01",
                                    "--out", "t.csv", "--script-limit", "0.5", "--memory-limit", "64MiB"});
  CHECK(run.out == "4 cases, 3 of them failed: t.csv\n");
  const auto rows = rows_of(read_file(folder / "t.csv"));
  CHECK_THAT(rows.at(2), Contains("did not come back within 0.5 s"));
  CHECK_THAT(rows.at(3), Contains("did not come back within 0.5 s"));
  CHECK_THAT(rows.at(4), Contains("memory") || Contains("did not come back"));
  const std::vector<std::string> ran = cells_of(rows.at(1)), stopped = cells_of(rows.at(3));
  const std::vector<std::string> names = cells_of(rows.at(0));
  const auto hash = static_cast<std::size_t>(std::find(names.begin(), names.end(), "hash") - names.begin());
  CHECK(ran.at(hash).size() == 16);
  CHECK(stopped.at(hash).empty());
}

TEST_CASE("sweep: a file that is changed while it runs or is stopped, though few cases read it, stops it") {
  Folder folder;
  write_file(folder / "mod.lua", "return 3");
  write_file(folder / "lazy.lua", R"(
    local v = scene:param("v", 1.0)
    scene:result("factor", v > 1.5 and require("mod") or 0)
    if v == 2 then error("wait") end
  )");
  const std::string path = folder / "t.csv.journal";
  const std::vector<std::string> arguments = {"sweep",   "lazy.lua", "--set", "v=1:2:40",
                                              "--until", "0.01",     "--out", "t.csv"};
  Process process(options(arguments, folder.path));
  while (!process.wait(0.002) && read_file(path).find("mod.lua") == std::string::npos) {}
  process.signal(SIGKILL);
  process.wait(10.0);
  if (!std::filesystem::exists(path)) return;  // it was done before it could be stopped
  write_file(folder / "mod.lua", "return 4");
  const Finished run = use(folder, arguments);
  CHECK(run.code != 0);
  CHECK_THAT(run.err, Contains("mod.lua was changed"));
}

TEST_CASE("sweep: where all cases fail the exit code tells, and the first error") {
  Folder folder;
  const Finished run = sweep_pendulum(folder, {"--set", "length=4.6,5"});
  CHECK(run.code == 1);
  CHECK_THAT(run.err, Contains("all failed") && Contains("too long"));
  CHECK(rows_of(read_file(folder / "t.csv")).size() == 3);
}

TEST_CASE("sweep: --retry-failed runs failed cases again, with another limit, and keeps the others") {
  Folder folder;
  write_file(folder / "slow.lua", R"(
    local loops = scene:param("loops", 1)
    require("factor")
    for i = 1, loops do end
  )");
  write_file(folder / "factor.lua", "return 1");
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"sweep", "slow.lua", "--set",   "loops=50000000,1,2", "--until", "0.01",
                                          "--out", "t.csv",    "--timed", "--script-limit"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return use(folder, arguments);
  };
  const Finished first = run({"0.05"});
  CHECK(first.out == "3 cases, 1 of them failed: t.csv\n");
  CHECK_THAT(first.err, Contains("--retry-failed"));
  const auto before = rows_of(read_file(folder / "t.csv"));
  CHECK_THAT(before.at(1), Contains("did not come back"));
  const std::string journal = read_file(folder / "t.csv.journal");
  const auto refused = [&](const char* why) {
    const Finished again = run({"100", "--retry-failed"});
    CHECK(again.code == 2);
    CHECK_THAT(again.err, Contains(why));
  };
  write_file(folder / "factor.lua", "return 2");  // the failed case was the first to read it
  refused("factor.lua was changed");
  write_file(folder / "factor.lua", "return 1");
  std::string altered = journal;
  altered[altered.find("\"steps\"") + 1] = 'S';
  write_file(folder / "t.csv.journal", altered);
  refused("this line was changed");
  write_file(folder / "t.csv.journal", journal);
  const Finished again = run({"100", "--retry-failed"});
  CHECK(again.out == "3 cases, 0 of them failed: t.csv\n");
  const auto after = rows_of(read_file(folder / "t.csv"));
  CHECK(after.at(1) != before.at(1));
  CHECK(std::vector(after.begin() + 2, after.end()) ==
        std::vector(before.begin() + 2, before.end()));  // `seconds`, too
  CHECK_THAT(run({"100", "--retry-failed"}).err, Contains("nothing is left to do"));
  std::filesystem::remove(folder / "t.csv.journal");
  refused("nothing to run again");
  CHECK(folder.files() == std::vector<std::string>{"factor.lua", "slow.lua", "t.csv"});
}

TEST_CASE(
    "sweep: where cases failed, --overwrite begins anew, of a changed scene, too; --retry-failed is then "
    "refused") {
  Folder folder;
  REQUIRE(sweep_pendulum(folder, {"--set", "length=4,5"}).code == 0);
  CHECK(folder.files() == std::vector<std::string>{"pendulum.lua", "t.csv", "t.csv.journal"});
  write_file(folder / "pendulum.lua", std::string(pendulum) + "scene:result('more', 1)");
  std::vector<std::string> same = {"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv", "--set", "length=4,5"};
  same.emplace_back("--retry-failed");
  CHECK_THAT(use(folder, same).err, Contains("another sweep, or its scene was changed"));
  same.back() = "--overwrite";
  const Finished again = use(folder, same);
  CHECK(again.out == "2 cases, 1 of them failed: t.csv\n");
  CHECK(again.err.find("going on") == std::string::npos);
  CHECK_THAT(read_file(folder / "t.csv"), Contains(",more,"));
  const Finished searched = use(
      folder, {"sweep", "pendulum.lua", "--out", "t.csv", "--set", "length=4:5", "--best", "noise", "--retry-failed"});
  CHECK(searched.code == 2);
  CHECK_THAT(searched.err, Contains("of no use to --best"));
}

TEST_CASE("sweep: fractions are numbers in the table, and whole numbers are drawn evenly") {
  CHECK(values_of(player::read_axis("a=1/4:1/2:2")) == std::vector<std::string>{"0.25", "0.5"});
  CHECK(values_of(player::read_axis("a=-1e308:1e308:3")) == std::vector<std::string>{"-1e+308", "0", "1e+308"});
  player::Axis whole = player::read_axis("n=1:3");
  whole.whole = true;
  std::map<std::string, int> drawn;
  for (std::uint64_t i = 0; i < 300; i++) drawn[player::Cases({whole}, 300).settings(i)[0].second]++;
  CHECK(drawn == std::map<std::string, int>{{"1", 100}, {"2", 100}, {"3", 100}});
  Folder folder;
  REQUIRE(sweep_pendulum(folder, {"--set", "scene.step=1/60,1/240"}).code == 0);
  CHECK_THAT(rows_of(read_file(folder / "t.csv")).at(2), Contains("1,0.004166666666666667,"));
}

TEST_CASE("sweep: whole numbers of a range that is logarithmic are drawn evenly in the logarithm") {
  player::Axis whole = player::read_axis("n=1:100:log");
  whole.whole = true;
  CHECK(whole.value_at(0.0) == "1");
  CHECK(whole.value_at(1.0) == "100");
  int below_ten = 0;
  for (std::uint64_t i = 0; i < 300; i++)
    below_ten += std::stod(player::Cases({whole}, 300).settings(i)[0].second) < 10 ? 1 : 0;
  CHECK(below_ten == Approx(300 * std::log(9.5 / 0.5) / std::log(100.5 / 0.5)).margin(2));
  Folder folder;
  CHECK_THAT(sweep_pendulum(folder, {"--set", "links=2.2:2.8", "--sample", "5"}).err,
             Contains("there is none from 2.2"));
}

TEST_CASE("sweep: names that are those of columns are told apart") {
  Folder folder;
  write_file(folder / "names.lua", R"(
    local v = scene:param("case", 1.0)
    for i, name in ipairs { "case", "case set", "case told", "steps", "x last" } do scene:result(name, i) end
    scene:probe("x", function() return 77 end)
  )");
  REQUIRE(use(folder, {"sweep", "names.lua", "--set", "case=8,9", "--until", "0.01", "--out", "t.csv"}).code == 0);
  const auto rows = rows_of(read_file(folder / "t.csv"));
  CHECK_THAT(rows.at(0), Contains("case,case set,case told,case set told,case told told,steps told,x last told,x last,"
                                  "x least,x largest,time,"));
  CHECK_THAT(rows.at(1), Contains("0,8,1,2,3,4,5,77,77,77,"));
}
