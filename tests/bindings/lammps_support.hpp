#pragma once
// Scenes for LAMMPS, and how tests export, run and read them.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bindings/program_support.hpp"
#include "lua/scene/open.hpp"

namespace pantin::support {

/// Atoms of Lennard-Jones in a box, a little off their places.
inline const char* const melt = R"(
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
inline const char* const springs = R"(
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
inline const char* const bodies = R"(
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
inline const char* const mixture = R"(
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

inline Finished export_scene(const Folder& folder, const std::string& source, std::vector<std::string> more = {}) {
  write_file(folder / "scene.lua", source);
  std::vector<std::string> arguments = {"export", "scene.lua", "--lammps", "files", "--until", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return use(folder, arguments);
}

/// With turns for processes, since the machine may have fewer processors; `path` before the usual one.
inline Finished run_scene(const Folder& folder, const std::string& source, std::vector<std::string> more,
                          const std::string& path = "") {
  write_file(folder / "scene.lua", source);
  std::vector<std::string> arguments = {"lammps", "scene.lua", "--out", "back.pantin", "--overwrite"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Process::Options all = options(arguments, folder.path);
  all.environment.emplace_back("OMPI_MCA_rmaps_base_oversubscribe=1");
  if (!path.empty()) all.environment.push_back("PATH=" + path);
  return finish(all);
}

inline bool have_lammps() {
  if (have_program("lmp") && have_program("mpirun")) return true;
  WARN("left out: there is no lmp and mpirun here (Debian's packages lammps and openmpi-bin)");
  return false;
}

inline double number_after(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  INFO(text);
  REQUIRE(at != std::string::npos);
  return std::strtod(text.c_str() + at + what.size(), nullptr);
}

/// The state that LAMMPS brought back.
inline std::unique_ptr<Scene> state_in(const Folder& folder) {
  return lua::open_state(read_file(folder / "back.pantin"), "back.pantin", {});
}

/// A program called lmp in the folder `bin`.
inline std::string fake_lmp(const Folder& folder, const std::string& script) {
  std::filesystem::create_directories(folder / "bin");
  write_file(folder / "bin/lmp", "#!/bin/sh\n" + script);
  std::filesystem::permissions(folder / "bin/lmp", std::filesystem::perms::owner_all);
  return (folder / "bin") + ":/usr/bin:/bin";
}

inline const std::string says_version =
    "[ \"$1\" = -h ] && { echo 'Large-scale Atomic/Molecular Massively Parallel Simulator - 29 Sep 2021'; echo; echo "
    "'Installed "
    "packages:'; echo; echo 'MOLECULE RIGID'; exit 0; }\n";

inline std::vector<std::string> scenes() {
  return {melt, read_file(sources::folder() + "/scripts/scenes/membrane.lua"), springs, bodies, mixture};
}

/// [J] at the start; checks that LAMMPS has our energy and forces then.
inline double total_energy(const std::string& source, const std::string& ranks, const std::string& until = "0.1") {
  const Folder folder;
  const Finished run = run_scene(folder, source, {"--until", until, "--ranks", ranks});
  INFO(source << run.err);
  REQUIRE(run.code == 0);
  CHECK(number_after(run.out, "the energy agrees to ") <= 1e-6);
  CHECK(number_after(run.out, "every force to ") <= 1e-6);
  CHECK(number_after(run.out, "at the end the energy to ") <= 1e-6);
  return number_after(run.out, "total energy ");
}

}  // namespace pantin::support
