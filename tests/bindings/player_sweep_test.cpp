// `pantin sweep`: cases, table and journal.
#include "player/sweep/sweep.hpp"

#include <catch2/catch.hpp>
#include <csignal>

#include "bindings/sweep_support.hpp"
#include "player/sweep/journal.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

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
