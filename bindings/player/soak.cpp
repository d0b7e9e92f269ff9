#include "player/soak.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/home.hpp"
#include "scene/errors.hpp"
#include "scene/printable.hpp"

namespace pantin::player {
namespace {

double resident_memory() {  // [MiB]
  std::ifstream file("/proc/self/statm");
  double size = 0.0, resident = 0.0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 0x1p20;
}

/// What probes keep of each step.
double recorded_memory(const World& world) {  // [MiB]
  std::size_t values = 0;
  for (const Probe& probe : world.probes) values += probe.values.size();
  return static_cast<double>(values * sizeof(double)) / 0x1p20;
}

double used_time() {  // [µs]
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

std::vector<std::string> scenes_to_soak(const SoakOptions& options, const std::string& home) {
  if (!options.scene.empty()) return {find_scene(options.scene, home)};
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(home) / "scripts" / "scenes"))
    if (file.path().extension() == ".lua") paths.push_back(file.path());
  std::ranges::sort(paths);
  return paths;
}

void soak_steps(Scene& scene, std::uint64_t steps) {
  for (std::uint64_t i = 0; i < steps && !scene.finished(); i++) {
    scene.step();
    require(scene.world().failure.empty(), scene.world().failure);
  }
}

/// Processor time a step, in µs.
double timed_steps(Scene& scene, std::uint64_t steps) {
  const std::uint64_t before = scene.world().steps;
  const double start = used_time();
  soak_steps(scene, steps);
  return (used_time() - start) / static_cast<double>(std::max<std::uint64_t>(1, scene.world().steps - before));
}

void print_soak(const Soak& s) {
  const std::string name = std::filesystem::path(s.scene).stem(), fault = s.fault();
  std::printf("%-16s %9llu %8.1f %8.1f %9.1f %9.1f %9.1e %9.1e %9.1e  %s\n", printable(name).c_str(),
              static_cast<unsigned long long>(s.steps), s.memory_early, s.memory_late, s.step_early, s.step_late,
              s.energy_early, s.energy_late, s.gap, printable(fault).c_str());
  std::fflush(stdout);
}

}  // namespace

std::string Soak::fault() const {
  constexpr double most_memory = 1.1, free_memory = 8.0;    // times, and MiB: what an allocator keeps
  constexpr double most_time = 3.0;                         // times: others use the machine, too
  constexpr double most_energy = 10.0, free_energy = 0.01;  // times, and of the kinetic energy
  if (!trouble.empty()) return trouble;
  if (memory_late > most_memory * memory_early + free_memory) return "its memory grows";
  if (step_late > most_time * step_early) return "its steps take longer and longer";
  if (!(energy_late <= most_energy * energy_early + free_energy)) return "its energy error grows";
  if (!(gap <= 1e-9 * extent)) return "its hinges gape";
  return "";
}

Soak soak_scene(const std::string& path, const std::string& home, std::uint64_t steps) {
  constexpr double hour = 3600.0;  // [s]
  SceneOptions options;
  options.home = home;
  const auto scene = lua::open_scene(path, options);
  World& world = scene->world();
  if (steps == 0) steps = static_cast<std::uint64_t>(std::llround(hour / world.settings.step));
  Soak soak;
  soak.scene = path;
  try {
    soak_steps(*scene, steps / 10);
    soak.memory_early = resident_memory() - recorded_memory(world);
    soak.step_early = timed_steps(*scene, steps / 4);
    soak.energy_early = world.worst.energy;
    soak_steps(*scene, steps - steps / 10 - 2 * (steps / 4));
    soak.step_late = timed_steps(*scene, steps / 4);
  } catch (const Error& error) { soak.trouble = error.what(); }
  soak.memory_late = resident_memory() - recorded_memory(world);
  soak.energy_late = world.worst.energy;
  soak.steps = world.steps;
  soak.gap = world.worst.hinge_gap;
  const Bounds box = bounds(world, everything(world));
  soak.extent = std::max({1.0, norm(box.low), norm(box.high)});
  return soak;
}

int soak(const SoakOptions& options, const std::string& home) {
  const std::vector<std::string> paths = scenes_to_soak(options, home);
  std::printf("%-16s %9s %17s %20s %19s %9s\n", "", "", "memory, MiB", "step, µs", "energy error", "worst");
  std::printf("%-16s %9s %8s %8s %9s %9s %9s %9s %9s\n", "scene", "steps", "early", "late", "early", "late", "early",
              "late", "gap, m");
  bool fine = true;
  for (const std::string& path : paths) {
    const Soak one = soak_scene(path, home, options.steps);
    print_soak(one);
    fine = fine && one.fault().empty();
  }
  return fine ? 0 : 1;
}

}  // namespace pantin::player
