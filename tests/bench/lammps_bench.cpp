// `pantin bench lmp`: a melt that is exported, run by `lmp` on two ranks, and by two threads of our own.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "lua/scene/open.hpp"
#include "player/bench.hpp"
#include "player/lammps/lammps.hpp"
#include "scene/scene.hpp"
#include "support/process.hpp"

using namespace pantin;

namespace {

constexpr int melt_steps = 50;

const char* const million = R"(
local cells = scene:param("cells", 63)
scene.gravity, scene.step = vec(0, 0, 0), 0.005
local edge, random = (4 / 0.8442) ^ (1 / 3), math.random
scene.box = cells * edge * vec(1, 1, 1)
local atoms = scene:family("atoms", { mass = 1 })
scene:interact(atoms, atoms, force.lennard_jones { sigma = 1, epsilon = 1, cutoff = 2.5 })
local corners = { vec(0, 0, 0), vec(0.5, 0.5, 0), vec(0.5, 0, 0.5), vec(0, 0.5, 0.5) }
for x = 0, cells - 1 do for y = 0, cells - 1 do for z = 0, cells - 1 do for _, p in ipairs(corners) do
  scene:particle { at = edge * (vec(x, y, z) + p), family = atoms,
    velocity = vec(4.2 * random() - 2.1, 4.2 * random() - 2.1, 4.2 * random() - 2.1) }
end end end end
)";

struct Ran {
  double clock = 0.0, processors = 0.0;  ///< [s]
};

void print_ran(const char* name, Ran ran, double atoms) {
  std::printf("%-44s %8.2f %10.2f %14.2f\n", name, ran.clock / melt_steps * 1e3, ran.processors / melt_steps * 1e3,
              1e-6 * atoms * melt_steps / ran.clock);
  std::fflush(stdout);
}

Ran run_by_lammps(const std::string& folder) {
  const support::Finished ended = support::finish(
      {{"mpirun", "-np", "2", "lmp", "-in", "in.scene", "-log", "none", "-var", "steps", text(melt_steps)},
       {"OMP_NUM_THREADS=1", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"},
       folder,
       -1});
  require(ended.code == 0, "LAMMPS ended with ", ended.code, ": ", ended.out, ended.err);
  const std::size_t time = ended.out.rfind("Loop time of "), use = ended.out.rfind("% CPU use");
  require(time != std::string::npos && use != std::string::npos, "LAMMPS does not tell its time");
  const double clock = std::strtod(ended.out.c_str() + time + 13, nullptr);
  const double part = std::strtod(ended.out.c_str() + ended.out.rfind('\n', use) + 1, nullptr);
  return {clock, clock * 0.01 * part * 2.0};
}

Ran run_here(Scene& scene) {
  scene.step();
  const double clock = now(2), processors = processor_time();
  for (int i = 0; i < melt_steps; i++) scene.step();
  return {now(2) - clock, processor_time() - processors};
}

void bench_lammps(const player::BenchOptions& options) {
  const support::Folder folder;
  support::write_file(folder / "melt.lua", million);
  SceneOptions scene_options;
  scene_options.threads = 2;
  scene_options.script_limit = 0.0;
  scene_options.memory_limit = std::size_t{16} << 30;
  if (!options.arguments.empty()) scene_options.set["cells"] = options.arguments[0];
  const double clock = now(2), processors = processor_time();
  player::LammpsOptions lammps;
  const std::string files = lammps.folder = folder / "files";
  player::export_lammps(lammps, {folder / "melt.lua", scene_options, 1.0, "melt.lua"});
  std::printf("opened and exported: %.1f s by the clock, %.1f s of processors\n\n", now(2) - clock,
              processor_time() - processors);
  const auto scene = lua::open_scene(folder / "melt.lua", scene_options);
  const auto atoms = static_cast<double>(scene->world().points.size());
  std::printf("%.0f atoms, %d steps%24s %8s %10s %14s\n", atoms, melt_steps, "", "ms/step", "CPU ms", "M atom-steps/s");
  print_ran("LAMMPS, 2 ranks, the table of the law", run_by_lammps(files), atoms);
  print_ran("Pantin, 2 threads", run_here(*scene), atoms);
  support::write_file(files + "/laws.tables", "pair_style lj/cut 2.5\npair_coeff * * 1 1\n");
  print_ran("LAMMPS, 2 ranks, its own lj/cut", run_by_lammps(files), atoms);
}

const player::Register lammps_benchmark(
    {"lmp", "a melt of 1,000,188 atoms by lmp on 2 ranks and by 2 threads here; argument: cells along an edge [63]",
     bench_lammps});

}  // namespace
