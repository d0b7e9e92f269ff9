// Scenes that LAMMPS runs: the same forces and energies, and back again. What needs `lmp` is left out where that is not there.
#include "player/lammps/lammps.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "bindings/program_support.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/lammps/folder.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

namespace {

/// Atoms of Lennard-Jones in a box, a little off their places.
const char* const melt = R"(
local cells = scene:param("cells", 5)
scene.step, scene.gravity = 0.004, vec(0, 0, 0)
local edge = (4 / 0.8442) ^ (1 / 3)
scene.box = cells * edge * vec(1, 1, 1)
local atoms = scene:family "atoms"
local function one() return math.random() - 0.5 end
for x = 0, cells - 1 do for y = 0, cells - 1 do for z = 0, cells - 1 do
  for _, p in ipairs { vec(0, 0, 0), vec(0.5, 0.5, 0), vec(0.5, 0, 0.5), vec(0, 0.5, 0.5) } do
    scene:particle { at = edge * (vec(x, y, z) + p + 0.05 * vec(one(), one(), one())), velocity = 4 * vec(one(), one(), one()),
      family = atoms, mass = 1 }
  end
end end end
scene:interact(atoms, atoms, force.lennard_jones { epsilon = 1, sigma = 1, cutoff = 2.5 })
)";

/// A lattice of springs that falls, turns and swings.
const char* const springs = R"(
local n = 6
scene.step = 1 / 480
local spring, made = force.spring { stiffness = 30, length = 0.1 }, {}
for x = 0, n - 1 do for y = 0, n - 1 do for z = 0, n - 1 do
  local i = (x * n + y) * n + z
  made[i] = scene:particle { at = 0.1 * vec(x, y, z) * (1 + 0.02 * math.sin(3 * x)), mass = 0.01, velocity = vec(y, 0, x) }
  if x > 0 then scene:connect(made[i - n * n], made[i], spring) end
  if y > 0 then scene:connect(made[i - n], made[i], spring) end
  if z > 0 then scene:connect(made[i - 1], made[i], spring) end
end end end
)";

/// Rigid rods and triangles that attract each other by a law that bends, and lie across the edges of the box.
const char* const bodies = R"(
scene.step, scene.gravity, scene.box = 0.005, vec(0, 0, 0), vec(9, 9, 9)
local ends = scene:family("ends")
local function turned() return quat(vec(math.random() - 0.5, math.random() - 0.5, 1), 6 * math.random()) end
for i = 0, 26 do
  local at = 3 * vec(i % 3, i // 3 % 3, i // 9)
  local points = { { at = vec(-0.6, 0, 0), mass = 1, family = ends }, { at = vec(0.6, 0, 0), mass = 2, family = ends } }
  if i % 2 == 0 then points[3] = { at = vec(0, 0.7, 0), mass = 1.5, family = ends } end
  scene:body { at = at, orientation = turned(), velocity = vec(math.random(), 0, 0), spin = vec(0, math.random(), 1), points = points }
end
scene:interact(ends, ends, force.hydrophobic { strength = 1, size = 0.9 })
)";

/// Two families, attributes, bonds of several kinds beside pairs, laws that bend or do not vanish, no box, fields, gravity.
const char* const mixture = R"(
scene.step, scene.gravity = 0.0005, vec(0, -1, 0)
local ions = scene:family("ions", { attributes = { charge = 1 }, mass = 1 })
local beads = scene:family("beads", { attributes = { size = 1 }, mass = 2 })
local list = {}
for i = 0, 124 do
  local p = 1.3 * vec(i % 5, i // 5 % 5, i // 25) + 0.1 * vec(math.random(), math.random(), math.random())
  if i % 2 == 0 then list[i] = scene:particle { at = p, family = ions, charge = i % 3 - 1 }
  else list[i] = scene:particle { at = p, family = beads, mass = 2 + i % 4, size = 0.9 + 0.1 * (i % 3) } end
end
scene:interact(ions, ions, force.pair { cutoff = 4,
  potential = function(r, a, b) return 2 * a.charge * b.charge * math.exp(-r) / r + 4 * r ^ -9 end })
scene:interact(beads, beads, force.pair { cutoff = 2.5, exclude = 1,
  potential = function(r, a, b) local s = 0.5 * (a.size + b.size) return 4 * ((s / r) ^ 12 - (s / r) ^ 6) end })
scene:interact(ions, beads, force.pair { cutoff = 3,
  tension = function(r, rate, a, b) return r < 1.5 and -3 * (1.5 - r) * b.size or 0 end })
for i = 1, 122, 2 do
  scene:connect(list[i], list[i + 2], force.pair { potential = function(r) return 5 * math.max(r - 2.4, 0) ^ 2 end })
  if i < 60 then scene:connect(list[i], list[i + 2], force.spring { stiffness = 4 + i % 4, length = 2.5 }) end
end
scene:field(ions, force.point { potential = function(p)
  return 0.3 * p.charge * p.position.y ^ 2 + 0.1 * math.sin(p.position.x) * p.mass end })
scene:field(scene, force.point { force = function(p) return vec(0.1 * p.position.z, 0, p.position.x < 2 and 0.2 or -0.1) end })
)";

Finished export_scene(const Folder& folder, const std::string& source, std::vector<std::string> more = {}) {
  write_file(folder / "scene.lua", source);
  std::vector<std::string> arguments = {"export", "scene.lua", "--lammps", "files", "--until", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return use(folder, arguments);
}

/// With turns for processes, since the machine may have fewer processors; `path` before the usual one.
Finished run_scene(const Folder& folder, const std::string& source, std::vector<std::string> more,
                   const std::string& path = "") {
  write_file(folder / "scene.lua", source);
  std::vector<std::string> arguments = {"lammps", "scene.lua", "--out", "back.pantin", "--overwrite"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Process::Options all = options(arguments, folder.path);
  all.environment.emplace_back("OMPI_MCA_rmaps_base_oversubscribe=1");
  if (!path.empty()) all.environment.push_back("PATH=" + path);
  return finish(all);
}

bool have_lammps() {
  if (have_program("lmp") && have_program("mpirun")) return true;
  WARN("left out: there is no lmp and mpirun here (Debian's packages lammps and openmpi-bin)");
  return false;
}

double number_after(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  INFO(text);
  REQUIRE(at != std::string::npos);
  return std::strtod(text.c_str() + at + what.size(), nullptr);
}

/// The state that LAMMPS brought back.
std::unique_ptr<Scene> state_in(const Folder& folder) {
  return lua::open_state(read_file(folder / "back.pantin"), "back.pantin", {});
}

/// A program called lmp in the folder `bin`.
std::string fake_lmp(const Folder& folder, const std::string& script) {
  std::filesystem::create_directories(folder / "bin");
  write_file(folder / "bin/lmp", "#!/bin/sh\n" + script);
  std::filesystem::permissions(folder / "bin/lmp", std::filesystem::perms::owner_all);
  return (folder / "bin") + ":/usr/bin:/bin";
}

const std::string says_version =
    "[ \"$1\" = -h ] && { echo 'Large-scale Atomic/Molecular Massively Parallel Simulator - 29 Sep 2021'; echo; echo "
    "'Installed "
    "packages:'; echo; echo 'MOLECULE RIGID'; exit 0; }\n";

std::vector<std::string> scenes() {
  return {melt, read_file(sources::folder() + "/scripts/scenes/membrane.lua"), springs, bodies, mixture};
}

/// [J] at the start; checks that LAMMPS has our energy and forces then.
double total_energy(const std::string& source, const std::string& ranks, const std::string& until = "0.1") {
  const Folder folder;
  const Finished run = run_scene(folder, source, {"--until", until, "--ranks", ranks});
  INFO(source << run.err);
  REQUIRE(run.code == 0);
  CHECK(number_after(run.out, "the energy agrees to ") <= 1e-6);
  CHECK(number_after(run.out, "every force to ") <= 1e-6);
  CHECK(number_after(run.out, "at the end the energy to ") <= 1e-6);
  return number_after(run.out, "total energy ");
}

}  // namespace

TEST_CASE("lammps: what is exported is the scene to the last digit, with its masses, box, bonds and molecules") {
  const Folder folder;
  REQUIRE(export_scene(folder, bodies).code == 0);
  const auto scene = lua::open_scene_text(bodies, "scene.lua", ".", {});
  std::istringstream data(read_file(folder / "files/scene.data"));
  std::string line;
  while (line.find("Atoms") != 0) REQUIRE(std::getline(data, line));
  std::size_t number = 0;
  for (ParticleId id : scene->world().particles.ids()) {
    double atom = 0, molecule = 0, type = 0, x = 0, y = 0, z = 0;
    data >> atom >> molecule >> type >> x >> y >> z;
    CHECK(atom == static_cast<double>(++number));
    CHECK(molecule >= 1.0);
    // Whole bodies are in the box with their first point; that is 9 m wide.
    const Vec3 away = (position(scene->world(), id) - vec(x, y, z)) / 9.0;
    for (int k = 0; k < 3; k++) CHECK(std::fabs(away[k] - std::round(away[k])) < 1e-15);
  }
  CHECK_THAT(read_file(folder / "files/scene.data"), Contains("0 9 xlo xhi") && Contains("3 atom types"));
  CHECK_THAT(read_file(folder / "files/in.scene"),
             Contains("rigid/small molecule") && Contains("boundary p p p") && Contains("Units"));
  CHECK_THAT(export_scene(folder, springs).out, Contains("216 particles of 1 type, 540 bonds, 0 bodies"));
  CHECK_THAT(read_file(folder / "files/in.scene"),
             Contains("boundary m m m") && Contains("fix gravity all gravity 9.81 vector 0 -9.81 0"));
}

TEST_CASE("lammps: formulas for those of 2023 on are beside the tables") {
  const Folder folder;
  REQUIRE(export_scene(folder, melt).code == 0);
  CHECK_THAT(read_file(folder / "files/laws.lepton"),
             Contains("pair_style hybrid/overlay lepton 2.5") && Contains("(r^(-12))"));
  CHECK_THAT(read_file(folder / "files/laws.tables"), Contains("pair_coeff 1 1 table pair.table PAIR1 2.5"));
}

TEST_CASE("lammps: what it cannot do ends with a list, and nothing is written") {
  const Folder folder;
  const Finished refused = export_scene(folder, std::string(melt) + "scene:every(1, function() end)\nscene:floor()\n");
  CHECK(refused.code == 1);
  CHECK_THAT(refused.err, Contains("scene.lua has what LAMMPS cannot be given:") && Contains("a shape that touches") &&
                              Contains("again and again (scene.lua:"));
  CHECK_FALSE(std::filesystem::exists(folder / "files"));
}

TEST_CASE("lammps: names of a scene are no lines of LAMMPS' scripts") {
  const Folder folder;
  REQUIRE(export_scene(folder, R"(
    local f = scene:family "atoms\nshell touch one\n#"
    scene:particle { at = vec(0, 0, 0), family = f }
    scene:field(f, force.point { name = "wind &\nshell touch two \"\"\"", force = function(p) return vec(1, 0, 0) end })
    scene:interact(f, f, force.pair { name = "a\nshell touch three", cutoff = 1, potential = function(r) return (1 - r) ^ 4 end })
  )")
              .code == 0);
  for (const char* name : {"in.scene", "scene.data", "pair.table", "laws.tables"}) {
    std::istringstream lines(read_file(folder / (std::string("files/") + name)));
    for (std::string line; std::getline(lines, line);) {
      INFO(name << ": " << line);
      CHECK((line.find("shell") == line.npos || line.find('#') < line.find("shell")));
    }
  }
}

TEST_CASE("lammps: what it would do otherwise than this program is refused") {
  const Folder folder;
  const auto why = [&](const std::string& source) {
    const Finished finished = export_scene(folder, source);
    CHECK(finished.code == 1);
    return finished.err;
  };
  CHECK_THAT(why("scene:body { points = { { at = vec(-1, 0, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 1 }, "
                 "{ at = vec(0, 1, 0), mass = 1e-8 } } }"),
             Contains("a body that is all but a line"));
  CHECK_THAT(why("scene:particle({ at = vec(0, 0, 0) }):push(vec(100, 0, 0))"),
             Contains("a push that the next step takes"));
  CHECK_THAT(why("scene.step = 0.01 local f = scene:family 'f' scene:particle { at = vec(0, 0, 0), family = f } "
                 "scene:field(f, force.thermostat { rate = 100, temperature = 1 })"),
             Contains("give it a rate of 20 /s or less"));
  CHECK_THAT(why("scene.box = vec(1, 1, 1) scene:particle { at = vec(0, 0, 0), velocity = vec(1000, 0, 0) }"),
             Contains("round the box more often than the 500 times"));
}

TEST_CASE("lammps: a law's narrow barrier is in its table, or is told to be too narrow") {
  const Folder folder;
  const auto pair = [](const char* at, const char* width) {
    return std::string(R"(
      scene.gravity, scene.box = vec(0, 0, 0), vec(40, 40, 40)
      local f = scene:family "f"
      for i = 1, 2 do scene:particle { at = vec(4 + 4 * i, 0, 0), velocity = vec(3 - 2 * i, 0, 0), family = f } end
      scene:interact(f, f, force.pair { cutoff = 10, potential = function(r)
        return 0.2 * math.exp(-r * r / 8) - 0.2 * math.exp(-12.5) + 5 * math.exp(-((r - )") +
           at + ") / " + width + R"() ^ 2) end }))";
  };
  REQUIRE(export_scene(folder, pair("1.5", "0.006")).code == 0);
  std::istringstream table(read_file(folder / "files/pair.table"));
  double highest = 0.0;
  for (std::string line; std::getline(table, line);) {
    double number = 0, r = 0, energy = 0;
    if (std::istringstream(line) >> number >> r >> energy && r > 1.4 && r < 1.6) highest = std::fmax(highest, energy);
  }
  CHECK(highest == Approx(5.15).epsilon(0.01));
  CHECK_THAT(export_scene(folder, pair("3.2", "0.0002")).err, Contains("something narrow"));
}

TEST_CASE("lammps: a law's damping, or friction of particles, that is 0 is left out and told") {
  const Folder folder;
  const std::string two = R"(
    scene.box = vec(10, 10, 10)
    local f = scene:family("f", { attributes = { grip = %GRIP% } })
    local a = scene:particle { at = vec(1, 1, 1), family = f }
    local b = scene:particle { at = vec(2, 1, 1), family = f }
    scene:connect(a, b, force.spring { stiffness = 5, length = 1, damping = %DAMPING% })
    scene:interact(f, f, force.pair { cutoff = 3, tension = function(r, rate, a, b)
      return (r - 3) ^ 2 + a.grip * b.grip * rate end })
    scene:field(f, force.drag { linear = %DRAG% })
    scene:field(f, force.wall { normal = vec(0, 1, 0), stiffness = 10, damping = %DRAG%, friction = %DRAG% })
  )";
  const auto with = [&](const char* grip, const char* damping, const char* drag) {
    std::string source = two;
    for (const auto& [name, value] : {std::pair("%GRIP%", grip), {"%DAMPING%", damping}, {"%DRAG%", drag}})
      for (std::size_t at; (at = source.find(name)) != source.npos;)
        source.replace(at, std::string(name).size(), value);
    return export_scene(folder, source);
  };
  const Finished none = with("0", "0", "0");
  INFO(none.err);
  CHECK(none.code == 0);
  CHECK_THAT(none.out, Contains("damping is 0, so that what depends on velocities or time is left out") &&
                           Contains("grip is 0") && Contains("linear is 0") && Contains("damping, friction are 0"));
  CHECK_THAT(with("1", "0", "0").err, Contains("leave its damping out"));
  CHECK_THAT(with("0", "1", "0").err, Contains("leave its damping out"));
  CHECK_THAT(with("0", "0", "1").err, Contains("it depends on velocities"));
}

TEST_CASE("lammps: a bond's table goes down to no length where its law does, and up to half the box") {
  const Folder folder;
  const auto spring = [&](const char* at, const char* law) {
    return export_scene(folder, std::string("scene.box = vec(10, 10, 10) scene.gravity = vec(0, 0, 0)\n") +
                                    "local a, b = scene:particle { at = vec(1, 1, 1) }, scene:particle { at = vec(" +
                                    at + ", 1, 1) }\nscene:connect(a, b, " + law + ")");
  };
  const auto distances = [&] {
    std::istringstream table(read_file(folder / "files/bond.table"));
    std::vector<double> list;
    for (std::string line; std::getline(table, line);) {
      double number = 0, r = 0, energy = 0;
      if (std::istringstream(line) >> number >> r >> energy) list.push_back(r);
    }
    return list;
  };
  REQUIRE(spring("2", "force.spring { stiffness = 5, length = 0 }").code == 0);
  CHECK(distances().front() == Approx(0.0).margin(1e-5));
  CHECK(distances().back() == Approx(5.0));
  REQUIRE(spring("2", "force.pair { potential = function(r) return 1 / r + r * r end }").code == 0);
  CHECK(distances().front() > 1e-4);
  const Finished island = spring(
      "2", "force.pair { potential = function(r) return (r - 1) ^ 2 + 0.1 * ((r - 1.285) ^ 2 - 2.5e-5) ^ 0.5 end }");
  CHECK_THAT(island.err, Contains("it is no finite number at 1.3 m"));
  for (const char* at : {"5.9", "6.1"})  // the nearest image is the one seen
    CHECK(spring(at, "force.spring { stiffness = 5 }").code == 0);
  const Finished across = export_scene(folder, R"(
    scene.box = vec(10, 4, 10)
    scene:connect(scene:particle { at = vec(1, 1, 1) }, scene:particle { at = vec(4, 1, 1) }, force.spring { stiffness = 5 })
  )");
  CHECK_THAT(across.err, Contains("longer than half an edge of the box") && Contains("make the box larger"));
}

TEST_CASE("lammps: wrong use is told before anything runs") {
  const Folder folder;
  std::filesystem::create_directories(folder / "files");
  write_file(folder / "files/thesis.txt", "mine");
  CHECK_THAT(export_scene(folder, melt).err, Contains("it holds files that are not of an export"));
  std::filesystem::create_directories(folder / "own");
  write_file(folder / "own/in.scene", "units metal\n");
  CHECK_THAT(use(folder, {"export", "scene.lua", "--lammps", "own"}).err, Contains("not of an export"));
  CHECK(read_file(folder / "own/in.scene") == "units metal\n");
  CHECK_THAT(use(folder, {"export", "scene.lua"}).err, Contains("--lammps"));
  CHECK_THAT(use(folder, {"lammps", "scene.lua", "--error", "2"}).err, Contains("1e-10 to 0.1"));
  CHECK_THAT(use(folder, {"lammps", "scene.lua", "--out", "x.csv"}).err, Contains(".pantin"));
  CHECK_THAT(use(folder, {"export", "scene.lua", "--lammps", "x", "--until", "0"}).err,
             Contains("less than half a step"));
  CHECK_THAT(use(folder, {"export", "none.lua", "--lammps", "x"}).err, Contains("there is no scene 'none.lua'"));
}

TEST_CASE("lammps: laws are exported with what the file sets after them") {
  const Folder folder;
  REQUIRE(export_scene(folder, R"(
    scene.gravity, scene.box = vec(0, 0, 0), vec(12, 12, 12)
    local constants, f = { k = 1 }, scene:family "f"
    local a, b = scene:particle { family = f, at = vec(5, 5, 5) }, scene:particle { family = f, at = vec(7, 5, 5) }
    scene:interact(f, f, force.pair { cutoff = 3, potential = function(r) return constants.k * (3 - r) ^ 3 end })
    scene:connect(a, b, force.pair { potential = function(r) return constants.k * (r - 1) ^ 2 end })
    scene:field(f, force.point { potential = function(p) return constants.k * p.position.x end })
    constants.k = 3
  )")
              .code == 0);
  CHECK(number_after(read_file(folder / "files/in.scene"), "Energy of all laws here: ") == Approx(42.0));
  CHECK_THAT(read_file(folder / "files/in.scene"), Contains("variable field1x atom \"(-3"));
  const auto checked = [&](const char* name, auto energy) {
    std::istringstream table(read_file(folder / name));
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
      double number = 0, r = 0, told = 0;
      if (!(std::istringstream(line) >> number >> r >> told)) continue;
      rows++;
      if (told != Approx(energy(r)).margin(1e-9)) return false;
    }
    return rows > 100;
  };
  CHECK(checked("files/pair.table", [](double r) { return 3.0 * std::pow(3.0 - r, 3.0); }));
  CHECK(checked("files/bond.table", [](double r) { return 3.0 * (r - 1.0) * (r - 1.0); }));
}

TEST_CASE("lammps: one fast or heavy particle, or a drift of all, makes no table coarser") {
  const Folder folder;
  const auto script_with = [&](const std::string& kinetic, const std::string& drift) {
    REQUIRE(export_scene(folder, R"(
      scene.gravity, scene.box, scene.step = vec(0, 0, 0), vec(30, 30, 30), 1e-5
      local f, g = scene:family "f", scene:family("g", { mass = 100 })
      for i = 0, 26 do
        scene:particle { at = vec(2, 2, 2) + 1.22 * vec(i % 3, i // 3 % 3, i // 9), velocity = vec(0.1 * (i % 2) + )" +
                                     drift + R"(, 0, 0), family = f }
      end
      scene:particle { at = vec(20, 20, 20), velocity = vec((2 * )" +
                                     kinetic + " / 100) ^ 0.5 + " + drift + R"(, 0, 0), family = g }
      scene:interact(f, f, force.pair { cutoff = 2.5,
        potential = function(r) return -math.exp(-((r - 1.2) / 0.08) ^ 2) + 0.5 * math.exp(-r * r / 0.3) end })
    )")
                .code == 0);
    const std::string script = read_file(folder / "files/in.scene");
    CHECK_THAT(script, !Contains("beside"));
    return number_after(script, "PAIR1: scene.lua:8: scene.lua:9, ");  // points
  };
  const double calm = script_with("1", "0");
  CHECK(script_with("1", "1000") == calm);
  CHECK(script_with("1e5", "0") >= calm);
}

TEST_CASE("lammps: a law that does nothing yet is held against what its own particles bring along, and that is told") {
  const Folder folder;
  REQUIRE(export_scene(folder, R"(
    scene.gravity, scene.box = vec(0, 0, 0), vec(30, 30, 30)
    local f, g = scene:family "f", scene:family("g", { mass = 100 })
    for i = 0, 1 do scene:particle { at = vec(5 + 8 * i, 5, 5), velocity = vec(2 - 4 * i, 0, 0), family = f } end
    scene:particle { at = vec(20, 20, 20), velocity = vec(30, 0, 0), family = g }
    scene:interact(f, f, force.pair { cutoff = 2.5, potential = function(r) return 5 * math.max(2 - r, 0) ^ 2 end })
  )")
              .code == 0);
  CHECK_THAT(read_file(folder / "files/in.scene"), Contains(" beside 0.2 J"));
}

TEST_CASE("lammps: within a family q1 with q2 is q2 with q1, whatever else tells particles apart") {
  const Folder folder;
  for (const char* masses : {"1", "3"}) {
    REQUIRE(export_scene(folder, std::string(R"(
      scene.gravity, scene.box, scene.step = vec(0, 0, 0), vec(9, 9, 9), 0.001
      local f = scene:family("f", { attributes = { q = 1 } })
      for i = 0, 63 do
        scene:particle { at = 2.1 * vec(i % 4, i // 4 % 4, i // 16), family = f, q = i * 3 % 5 + 1, mass = i % )") +
                                     masses + R"( + 1 }
      end
      scene:interact(f, f, force.pair { cutoff = 3, potential = function(r, a, b) return a.q * b.q / r end })
    )")
                .code == 0);
    const std::string laws = read_file(folder / "files/in.scene");
    CHECK_THAT(laws, Contains("PAIR15:") && !Contains("PAIR16:"));
  }
}

TEST_CASE("lammps: a bond's table ends where its law jumps") {
  const Folder folder;
  REQUIRE(export_scene(folder, R"(
    scene.gravity = vec(0, 0, 0)
    local a, b = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0.1, 0) }
    scene:connect(a, b, force.table { distances = { 0.5, 1, 2 }, tensions = { -5, 0, 3 } })
  )")
              .code == 0);
  CHECK_THAT(read_file(folder / "files/in.scene"), Contains(" to 2.0"));
}

TEST_CASE("lammps: an open scene may be as small as atoms are") {
  if (!have_lammps()) return;
  const std::string small = R"(
    local A = 1e-10
    scene.step, scene.gravity, scene.boltzmann = 2e-15, vec(0, 0, 0), 1.380649e-23
    local f = scene:family("ar", { mass = 6.63e-26 })
    for i = 0, 63 do scene:particle { at = A * vec(4 * (i % 4), 4.2 * (i // 4 % 4), 4.5 * (i // 16)), family = f } end
    scene:interact(f, f, force.lennard_jones { epsilon = 1.65e-21, sigma = 3.4e-10 })
  )";
  total_energy(small, "1", "2e-13");
}

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
