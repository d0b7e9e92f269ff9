// `pantin sweep` by several processes, and where some die, fail or take too long.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "bindings/sweep_support.hpp"
#include "player/sweep/bundle.hpp"
#include "player/sweep/course.hpp"
#include "player/sweep/foreman.hpp"
#include "player/sweep/journal.hpp"
#include "player/sweep/workers.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

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
