// What is exported for LAMMPS, and what is refused.
#include "player/lammps/lammps.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "bindings/lammps_support.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

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
