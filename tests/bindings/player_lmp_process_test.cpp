// Scenes that LAMMPS runs: the same forces and energies, and back again. What needs `lmp` is left out where that is not there.
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "bindings/lammps_support.hpp"
#include "measure/measure.hpp"
#include "player/lammps/folder.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

TEST_CASE("lammps: an lmp that is missing, old, another program, fails, dies or lies is told in one sentence") {
  const Folder folder;
  const auto told = [&](const std::string& path) {
    const Finished run = run_scene(folder, melt, {"--until", "0.1", "--ranks", "1"}, path);
    CHECK(run.code == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "back.pantin"));
    return run.err;
  };
  CHECK_THAT(told(folder / "bin"), Contains("install Debian's package lammps"));
  CHECK_THAT(told(fake_lmp(folder, "echo 'Large-scale Atomic/Molecular Massively Parallel Simulator - 7 Aug 2019'")),
             Contains("lmp is LAMMPS of 7 Aug 2019, and 29 Sep 2021 or newer is needed"));
  CHECK_THAT(told(fake_lmp(folder, "echo hello")), Contains("is another program called lmp?"));
  CHECK_THAT(
      told(fake_lmp(folder, says_version + "touch log.lammps; echo 'ERROR: Lost atoms: original 4 current 3'; exit 1")),
      Contains("LAMMPS: ERROR: Lost atoms") && Contains("the step is too long") && Contains("back/log.lammps"));
  CHECK_THAT(told(fake_lmp(folder, says_version + "kill -9 $$")), Contains("ended by signal 9 (Killed)"));
  CHECK_THAT(told(fake_lmp(folder, says_version + "echo 'Exit code:    137'; exit 137")),
             Contains("ended by signal 9 (Killed), as the system does where memory is short"));
  std::filesystem::remove(folder / "back/log.lammps");
  CHECK_THAT(told(fake_lmp(folder, says_version + "exit 3")),
             Contains("it ended with exit code 3") && !Contains("log.lammps"));
  CHECK_THAT(told(fake_lmp(folder, "echo 'lmp: cannot open shared object file' >&2; exit 127")),
             Contains("`lmp -h` fails: it ended with exit code 127, and said last: lmp: cannot open shared"));
  CHECK_THAT(told(fake_lmp(folder, says_version + "touch end.dump")), Contains("did not tell its forces"));
  CHECK_THAT(told(fake_lmp(folder, says_version +
                                       "(echo ITEM: NUMBER OF ATOMS; echo 500; echo ITEM: ATOMS id fx fy fz; for i in "
                                       "`seq 500`; do echo $i 1 0 0; done) > start.dump; echo 'pantin: energy 1'; echo "
                                       "'pantin: start.dump is there'")),
             Contains("LAMMPS has another force on particle"));
  CHECK_THAT(
      told(fake_lmp(folder, says_version +
                                "(echo ITEM: NUMBER OF ATOMS; echo 500; echo ITEM: ATOMS; echo 1 nan) > start.dump; "
                                "echo 'pantin: energy 1'; echo 'pantin: start.dump is there'")),
      Contains("start.dump"));
}

TEST_CASE("lammps: a law that is NaN somewhere is told to be, and where") {
  const Folder folder;
  const auto why = [&](const char* law) {
    return export_scene(folder, std::string("scene.gravity, scene.box = vec(0, 0, 0), vec(9, 9, 9)\n") +
                                    "local f = scene:family 'f' for i = 1, 2 do scene:particle { at = vec(i, 0, 0), "
                                    "family = f } end\nscene:interact(f, f, force.pair { cutoff = 2, tension = " +
                                    law + " })")
        .err;
  };
  CHECK_THAT(why("function(r) return math.sqrt(r - 1) end"), Contains("It is NaN at 0.99 m"));
  CHECK_THAT(why("function(r) return math.sqrt(r - 1.2) end"), Contains("(NaN) at 1 m"));
  CHECK_THAT(why("function(r) return math.sqrt((r - 1.4) ^ 2 - 0.01) end"), Contains("finite number at 1.5 m (NaN)"));
}

TEST_CASE("lammps: what is printed to be typed is quoted, and what an export before left is set aside") {
  const Folder folder;
  write_file(folder / "scene.lua", melt);
  const std::vector<std::string> arguments = {"export", "scene.lua", "--lammps", "my files", "--set", "cells=3"};
  CHECK_THAT(use(folder, arguments).out, Contains("cd 'my files' && lmp -in in.scene") &&
                                             Contains("--set cells=3 --from-dump 'my files/end.dump'"));
  write_file(folder / "my files/end.dump", "old");
  CHECK_THAT(use(folder, arguments).out, Contains("left of an export before is my files/earlier-end.dump now"));
  CHECK_FALSE(std::filesystem::exists(folder / "my files/end.dump"));
  CHECK(read_file(folder / "my files/earlier-end.dump") == "old");
}

TEST_CASE("lammps: a dump of an export with other parameters is refused") {
  const Folder folder;
  write_file(folder / "scene.lua", "local k = scene:param('k', 1.0)\nscene:particle { at = vec(0, 0, 0) }");
  REQUIRE(use(folder, {"export", "scene.lua", "--lammps", "files", "--until", "1", "--set", "k=2"}).code == 0);
  write_file(folder / "files/end.dump",
             "ITEM: TIMESTEP\n120\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS mm mm mm\n0 1\n0 1\n0 "
             "1\nITEM: ATOMS id xu yu zu vx vy vz\n1 4 1 0 0 0 1\n");
  const auto bring = [&](const char* set) {
    return use(folder, {"lammps", "scene.lua", "--from-dump", "files/end.dump", "--set", set, "--out", "b c.pantin"});
  };
  const Finished other = bring("k=3");
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("of an export with other parameters, k=2, and here they are k=3"));
  CHECK_THAT(bring("k=2.0").out, Contains("1 particle of step 120") && Contains("(pantin play 'b c.pantin')"));
}

TEST_CASE("lammps: where the state cannot be saved the dump stays, and is not lost without a wish") {
  const Folder folder;
  write_file(folder / "scene.lua", "scene.gravity = vec(0, 0, 0) scene:particle { at = vec(0, 0, 0) }");
  const std::string path = fake_lmp(folder, says_version + R"(
    head='ITEM: TIMESTEP\n120\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS mm mm mm\n0 1\n0 1\n0 1\nITEM: ATOMS id'
    printf "$head fx fy fz\n1 0 0 0\n" > start.dump
    printf "$head xu yu zu vx vy vz\n1 4 1 0 0 0 1\n" > end.dump
    echo 'pantin: energy 0'; echo 'pantin: start.dump is there'; echo 'pantin: energy at the end 0'
    mkdir -p ../gone; rm -r ../gone
  )");
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"lammps", "scene.lua", "--until", "0.5",   "--ranks",
                                          "1",      "--folder",  "files",   "--out", "gone/a b.pantin"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Process::Options all = options(arguments, folder.path);
    all.environment.push_back("PATH=" + path);
    return finish(all);
  };
  std::filesystem::create_directories(folder / "gone");
  const Finished first = run({});
  INFO(first.out << first.err);
  CHECK(first.code != 0);
  CHECK_THAT(first.err, Contains("pantin lammps scene.lua --from-dump files/end.dump --out 'gone/a b.pantin'"));
  CHECK(std::filesystem::exists(folder / "files/end.dump"));
  std::filesystem::create_directories(folder / "gone");
  CHECK_THAT(run({}).err, Contains("files/end.dump is left of a run before") && Contains("--overwrite"));
  CHECK(use(folder, {"lammps", "scene.lua", "--from-dump", "files/end.dump", "--out", "back.pantin"}).code == 0);
}

TEST_CASE("lammps: Ctrl-C ends LAMMPS, too, and brings nothing back") {
  const Folder folder;
  write_file(folder / "scene.lua", melt);
  Process::Options all =
      options({"lammps", "scene.lua", "--out", "back.pantin", "--ranks", "1", "--until", "1"}, folder.path);
  all.environment.push_back("PATH=" + fake_lmp(folder, says_version + "touch begun; sleep 300; touch ended"));
  Process run(all);
  for (int i = 0; i < 600 && !std::filesystem::exists(folder / "back/begun"); i++) REQUIRE_FALSE(run.wait(0.1));
  run.signal(SIGINT);
  CHECK(run.wait(30.0) == 1);
  CHECK_THAT(run.err(), Contains("stopped: LAMMPS was ended, and nothing is brought back"));
  CHECK_FALSE(std::filesystem::exists(folder / "back.pantin"));
}

TEST_CASE("lammps: more processes than mpirun has place for, or no mpirun, is told with what to do") {
  const Folder folder;
  std::string path = fake_lmp(folder, says_version);
  write_file(folder / "bin/mpirun",
             "#!/bin/sh\necho 'There are not enough slots available in the system to satisfy the 4'; exit 1");
  std::filesystem::permissions(folder / "bin/mpirun", std::filesystem::perms::owner_all);
  CHECK_THAT(
      run_scene(folder, melt, {"--until", "0.1", "--ranks", "4"}, path).err,
      Contains("mpirun has no place for 4 processes") && Contains("fewer --ranks") && Contains("oversubscribe=1"));
  std::filesystem::remove(folder / "bin/mpirun");
  path = folder / "bin";
  std::filesystem::create_symlink("/bin/sh", folder / "bin/sh");
  CHECK_THAT(run_scene(folder, melt, {"--until", "0.1", "--ranks", "4"}, path).err,
             Contains("install Debian's package openmpi-bin"));
}

TEST_CASE("lammps: melt, springs and bodies have our energy and forces") {
  if (!have_lammps()) return;
  for (const char* source : {melt, springs, bodies}) total_energy(source, "1");
}

TEST_CASE("lammps: the energy at the end is that of the laws, however much that of gravity has changed") {
  if (!have_lammps()) return;
  total_energy(R"(
    scene.step, scene.gravity, scene.box = 0.002, vec(0, -9.81, 0), vec(8, 8, 8)
    local heavy = scene:family("heavy", { mass = 1e6 })
    for i = 0, 26 do scene:particle { family = heavy, at = vec(1 + 2 * (i % 3), 1 + 2 * (i // 3 % 3), 1 + 2 * (i // 9)) } end
    scene:interact(heavy, heavy, force.pair { cutoff = 2.5, potential = function(r) return 1e-6 * (2.5 - r) ^ 3 end })
  )",
               "1", "5");
}

TEST_CASE("lammps: so have a membrane and a mixture, and on 2 and 4 ranks all is as on 1", "[slow]") {
  if (!have_lammps()) return;
  for (const std::string& source : scenes()) {
    const double alone = total_energy(source, "1");
    for (const char* ranks : {"2", "4"}) CHECK(total_energy(source, ranks) == Approx(alone).epsilon(1e-9));
  }
}

TEST_CASE("lammps: sides of a field's choice that are not finite do not spoil the other") {
  if (!have_lammps()) return;
  total_energy(R"(
    scene.step, scene.gravity, scene.box = 0.001, vec(0, 0, 0), vec(10, 10, 10)
    local f = scene:family("f")
    for i = 0, 5 do scene:particle { at = vec(1 + 1.5 * i, 5, 5), family = f } end
    scene:field(f, force.point { force = function(p)
      local x = p.position.x - 5
      local root = where(x > 0.01, math.sqrt(x) + math.log(x) + 1 / math.sqrt(x), where(x < -0.5, (-x) ^ -0.7, math.exp(800 * x)))
      return vec(root, x < 1 and math.asin(x / 9) / x or math.exp(-x), 0)
    end })
    scene:interact(f, f, force.pair { cutoff = 3, potential = function(r) return (3 - r) ^ 3 end })
  )",
               "1", "0.02");
}

TEST_CASE("lammps: springs of no length go through it") {
  if (!have_lammps()) return;
  total_energy(R"(
    scene.step, scene.gravity = 0.001, vec(0, 0, 0)
    local f = scene:family("f")
    local a, b = scene:particle { at = vec(-1, 0, 0), family = f }, scene:particle { at = vec(1, 0, 0), family = f }
    scene:connect(a, b, force.spring { stiffness = 20, length = 0 })
  )",
               "1", "3");
}

TEST_CASE("lammps: particles of a soft law may go through each other") {
  if (!have_lammps()) return;
  total_energy(R"(
    scene.step, scene.gravity, scene.box = 0.001, vec(0, 0, 0), vec(12, 12, 12)
    local f = scene:family("f")
    scene:particle { at = vec(5, 5, 5), family = f }
    scene:particle { at = vec(7, 5.0005, 5), family = f, velocity = vec(-4, 0, 0) }
    scene:interact(f, f, force.pair { cutoff = 3, potential = function(r) return math.exp(-r * r) end })
  )",
               "1", "1");
}

TEST_CASE("lammps: a spring may stretch to several times its length, by one process and by two") {
  if (!have_lammps()) return;
  for (const char* ranks : {"1", "2"})
    total_energy(R"(
      scene.step, scene.gravity, scene.box = 0.01, vec(0, 0, 0), vec(10, 10, 10)
      local heavy = scene:particle { mass = 100, at = vec(9.95, 5, 5) }
      local light = scene:particle { mass = 1, at = vec(10.95, 5, 5), velocity = vec(6, 0, 0) }
      scene:connect(heavy, light, force.spring { stiffness = 4 })
    )",
                 ranks, "2");
}

TEST_CASE("lammps: what it wrote elsewhere comes back by --from-dump as what it does here") {
  if (!have_lammps()) return;
  const auto [source, steps] = GENERATE(table<const char*, const char*>({{melt, "100"}, {bodies, "80"}}));
  const Folder folder;
  const auto bring = [&](const std::string& dump, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"lammps", "scene.lua",     "--from-dump", dump,
                                          "--out",  "dumped.pantin", "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return use(folder, arguments);
  };
  REQUIRE(run_scene(folder, source, {"--until", "0.4", "--ranks", "1"}).code == 0);
  const Finished exported = export_scene(folder, source);
  CHECK_THAT(exported.out, Contains("back: pantin lammps ") && Contains(" --from-dump files/end.dump"));
  CHECK_THAT(read_file(folder / "files/in.scene"), Contains("--from-dump files/end.dump"));
  REQUIRE(finish({{"lmp", "-in", "in.scene", "-log", "none", "-var", "steps", steps, "-var", "restart", "40"},
                  {},
                  folder / "files",
                  -1})
              .code == 0);
  const Finished run = bring("files/end.dump");
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK_THAT(run.out, Contains("0.4 s: dumped.pantin"));
  const auto here = state_in(folder), there = lua::open_state(read_file(folder / "dumped.pantin"), "dumped.pantin", {});
  CHECK(there->world().time == Approx(here->world().time));
  double apart = 0.0;
  for (ParticleId id : here->world().particles.ids())
    apart = std::max(apart, norm(position(here->world(), id) - position(there->world(), id)) +
                                norm(velocity(here->world(), id) - velocity(there->world(), id)));
  CHECK(apart < 1e-12);

  const std::string dump = read_file(folder / "files/end.dump");
  write_file(folder / "two.dump", dump + dump.substr(0, dump.size() / 2));  // ended while the second was written
  CHECK(bring("two.dump").code == 0);
  const auto refused = [&](std::string changed, const char* what, const char* by, const char* why) {
    changed.replace(changed.find(what), std::string(what).size(), by);
    write_file(folder / "bad.dump", changed);
    const Finished bad = bring("bad.dump");
    CHECK(bad.code == 1);
    CHECK_THAT(bad.err, Contains("bad.dump") && Contains(why));
  };
  refused(dump, "TIMESTEP\n", "TIMESTEP\n1e30\n", "it is of timestep 1e+30");
  refused(dump, " xu yu", " xs ys", "it has no column 'xu'");
  refused(dump, "\n1 ", "\n1abc ", "'1abc' is no number");
  refused(dump, " xu yu zu", " x y z", "it has no column 'xu'");
  refused(dump, "ITEM: ATOMS", "ITEM: ATOM", "no whole dump");
  refused(dump, "ITEM: TIMESTEP", "LAMMPS data", "no text dump");
  refused(dump.substr(0, dump.size() - 5), "ITEM", "ITEM", "no whole dump");
  CHECK_THAT(bring("files/scene.data").err, Contains("no text dump of LAMMPS"));
  CHECK_THAT(bring("none.dump").err, Contains("none.dump"));
  if (exported.err.empty() && dump.find("BOX BOUNDS pp pp pp") != std::string::npos) {  // by a barostat, say
    const std::size_t box = dump.find('\n', dump.find("BOX BOUNDS")) + 1;
    refused(dump, dump.substr(box, dump.find('\n', box) - box).c_str(), "0 7", "its box is 7 x");
  }
  CHECK_THAT(bring("files/end.dump", {"--ranks", "2"}).err, Contains("--ranks"));
  CHECK_THAT(bring("files/end.dump", {"--until", "0.5"}).err, Contains("is at 0.4 s by the scene's step; it is taken"));
}

TEST_CASE("lammps: a state that is there is lost with --overwrite alone, and two into one folder are refused") {
  const Folder folder;
  write_file(folder / "scene.lua", melt);
  write_file(folder / "back.pantin", "mine");
  const Finished run = use(folder, {"lammps", "scene.lua", "--out", "back.pantin"});
  CHECK(run.code == 2);
  CHECK_THAT(run.err, Contains("back.pantin is there already") && Contains("--overwrite"));
  CHECK(read_file(folder / "back.pantin") == "mine");
  const player::FolderLock first(folder / "files");
  CHECK_THAT(use(folder, {"export", "scene.lua", "--lammps", "files"}).err,
             Contains("another program is writing into files"));
}

TEST_CASE("lammps: a dump of other particles is told as one") {
  const Folder folder;
  const auto bring = [&](const std::string& rows) {
    write_file(folder / "scene.lua", R"(
      scene:particle { at = vec(0, 0, 0) }
      scene:body { at = vec(5, 0, 0), points = { { at = vec(-1, 0, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 1 } } }
    )");
    write_file(folder / "x.dump",
               "ITEM: TIMESTEP\n120\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS mm mm mm\n0 1\n0 1\n0 "
               "1\nITEM: ATOMS vx vy vz id element x y z\n" +
                   rows);
    return use(folder, {"lammps", "scene.lua", "--from-dump", "x.dump", "--out", "back.pantin", "--overwrite"});
  };
  const Finished good = bring("0 0 1 2 H 4 1 0\n0 0 1 3 H 6 1 0\n1 2 3 1 H 7 8 9\n");
  INFO(good.err);
  REQUIRE(good.code == 0);
  const auto state = state_in(folder);
  CHECK(state->world().time == Approx(0.5));
  CHECK(norm(position(state->world(), state->world().particles.ids()[0]) - vec(7, 8, 9)) < 1e-12);
  CHECK(norm(velocity(state->world(), state->world().particles.ids()[2]) - vec(0, 0, 1)) < 1e-12);
  CHECK_THAT(bring("0 0 1 2 H 4 1 0\n0 0 1 3 H 8 1 0\n1 2 3 1 H 7 8 9\n").err, Contains("another shape in LAMMPS"));
  CHECK_THAT(bring("0 0 1 2 H 4 1 0\n0 0 1 2 H 6 1 0\n1 2 3 1 H 7 8 9\n").err, Contains("comes twice"));
  CHECK_THAT(bring("0 0 1 2 H 4 1 nan\n0 0 1 3 H 6 1 0\n1 2 3 1 H 7 8 9\n").err, Contains("atom 2 has nan as its z"));
  CHECK_THAT(bring("0 0 1 2 H 4 1 0\n0 0 1e300 3 H 6 1 0\n1 2 3 1 H 7 8 9\n").err,
             Contains("atom 3 has 1e300 as its vz"));
  CHECK_THAT(bring("0 0 1 2 H 4 1 0\n0 0 1 3 H 6.00001 1 0\n1 2 3 1 H 7 8 9\n").err,
             Contains("too few digits") && Contains("%.17g"));
  CHECK_THAT(bring("0 0 1 2 H 4 1 0\n100 0 1 3 H 6 1 0\n1 2 3 1 H 7 8 9\n").err,
             Contains("moves in LAMMPS as no rigid body does"));
  CHECK_THAT(bring("0 0 1 2 H 4 1\n").err, Contains("no whole dump"));
}

TEST_CASE("lammps: where it ends is where this program comes to, and the scene goes on from there") {
  if (!have_lammps()) return;
  // Without chaos in so short a time: both are velocity Verlet, but that turns of bodies are done otherwise.
  const auto [source, until, near] =
      GENERATE(table<const char*, double, double>({{springs, 0.5, 1e-9}, {melt, 0.4, 1e-4}, {bodies, 0.5, 1e-3}}));
  const Folder folder;
  const Finished run = run_scene(folder, source, {"--until", to_text(until), "--ranks", "2"});
  INFO(run.err);
  REQUIRE(run.code == 0);
  const auto brought = state_in(folder);
  const auto here = lua::open_scene_text(source, "scene.lua", ".", {});
  while (here->world().time < until - 0.5 * here->world().settings.step) here->step();
  CHECK(brought->world().time == Approx(here->world().time));
  double apart = 0.0, apart_in_speed = 0.0;
  for (ParticleId id : here->world().particles.ids()) {
    apart = std::max(apart, norm(position(here->world(), id) - position(brought->world(), id)));
    apart_in_speed = std::max(apart_in_speed, norm(velocity(here->world(), id) - velocity(brought->world(), id)));
  }
  CHECK(apart < near);
  CHECK(apart_in_speed < 30.0 * near);
  const double energy_there = energy(brought->world()).total();
  CHECK(energy_there == Approx(energy(here->world()).total()).epsilon(1e-4));
  for (int i = 0; i < 50; i++) brought->step();
  CHECK(brought->world().time == Approx(until + 50 * here->world().settings.step));
  CHECK(energy(brought->world()).total() == Approx(energy_there).epsilon(1e-3));
  CHECK(brought->world().error.energy < 1e-2);
}

TEST_CASE("lammps: over 1000 steps a table keeps the energy as LAMMPS' own Lennard-Jones does") {
  if (!have_lammps()) return;
  const Folder folder;
  REQUIRE(run_scene(folder, melt, {"--until", "4", "--ranks", "1"}).code == 0);
  const auto energies = [&](const std::string& log) {
    std::istringstream lines(log.substr(log.rfind("Step ")));
    std::string line;
    std::getline(lines, line);
    std::vector<double> list;
    for (double step, potential, kinetic, total, temperature;
         lines >> step >> potential >> kinetic >> total >> temperature;)
      list.push_back(total);
    return list;
  };
  const std::vector<double> by_table = energies(read_file(folder / "back/log.lammps"));
  write_file(folder / "back/laws.tables", "pair_style lj/cut 2.5\npair_coeff * * 1 1\npair_modify shift yes\n");
  REQUIRE(finish({{"lmp", "-in", "in.scene", "-log", "own.lammps"}, {}, folder / "back", -1}).code == 0);
  const std::vector<double> own = energies(read_file(folder / "back/own.lammps"));
  REQUIRE(own.size() == by_table.size());
  REQUIRE(own.size() > 100);
  const auto spread = [](const std::vector<double>& list) {
    double most = 0.0;
    for (double e : list) most = std::max(most, std::abs(e - list[0]));
    return most / std::abs(list[0]);
  };
  CHECK(by_table[0] == Approx(own[0]).epsilon(1e-9));
  CHECK(spread(by_table) < 1.2 * spread(own) + 1e-7);
}

TEST_CASE("lammps: a thermostat holds the temperature of what is brought back") {
  if (!have_lammps()) return;
  const Folder folder;
  REQUIRE(run_scene(folder, std::string(melt) + "scene:field(scene, force.thermostat { rate = 5, temperature = 1.7 })",
                    {"--until", "4", "--ranks", "2"})
              .code == 0);
  const auto brought = state_in(folder);
  CHECK(temperature(brought->world(), everything(brought->world())) == Approx(1.7).epsilon(0.1));
}
