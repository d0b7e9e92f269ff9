// `pantin bench scale`: scenes of a million things from Lua: how long they take to open, what memory they take, their steps.
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "bench/clock.hpp"
#include "forces/forces.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/bench.hpp"
#include "scene/scene.hpp"

using namespace pantin;

namespace {

constexpr int window = 5, windows = 4, threads = 2;

struct Big {
  const char* argument;
  const char* name;
  double things;  ///< that the figures are divided by
  const char* source;
};

constexpr Big scenes[] = {{"particles", "1,000,000 particles, Lennard-Jones", 1e6, R"(
local n, apart = 100, 1.0583
scene.gravity, scene.step = vec(0, 0, 0), 0.002
scene.box = n * apart * vec(1, 1, 1)
local atoms = scene:family("atoms", { mass = 1 })
scene:interact(atoms, atoms, force.lennard_jones { sigma = 1, epsilon = 1, cutoff = 2.5 })
local random = math.random
for x = 1, n do for y = 1, n do for z = 1, n do
  scene:particle { at = vec(x * apart, y * apart, z * apart), family = atoms,
    velocity = vec(4 * random() - 2, 4 * random() - 2, 4 * random() - 2) }
end end end
)"},
                          {"springs", "1,014,300 springs, 343,000 particles", 1014300, R"(
local n = 70
scene.gravity, scene.step = vec(0, 0, 0), 0.005
local spring = force.pair { parameters = { stiffness = 10, length = 1 },
  potential = function(r, a, b, own) return 0.5 * own.stiffness * (r - own.length)^2 end }
local made, random = {}, math.random
for x = 0, n - 1 do for y = 0, n - 1 do for z = 0, n - 1 do
  local i = (x * n + y) * n + z
  local p = scene:particle { at = vec(x, y, z), velocity = vec(random(), random(), random()) }
  made[i] = p
  if x > 0 then scene:connect(made[i - n * n], p, spring) end
  if y > 0 then scene:connect(made[i - n], p, spring) end
  if z > 0 then scene:connect(made[i - 1], p, spring) end
end end end
)"},
                          {"bodies", "100,000 bodies on hinges, 5000 chains", 1e5, R"(
scene.step = 1 / 240
for chain = 1, 5000 do
  local previous
  for i = 1, 20 do
    local link = scene:body { mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(i - 0.5, 0, chain),
      points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    if previous then scene:hinge(previous.tail, link.head) else scene:nail(link.head) end
    previous = link
  end
end
)"}};

/// [bytes] that the process has in memory.
double resident() {
  std::ifstream statm("/proc/self/statm");
  double size = 0.0, pages = 0.0;
  statm >> size >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

template <class Row>
double row_bytes(const Store<Row>& rows) {
  return static_cast<double>(rows.size() * sizeof(Row));
}

/// [bytes] of the rows of what was made, without what they hold elsewhere.
double row_bytes(const World& w) {
  return row_bytes(w.points) + row_bytes(w.particles) + row_bytes(w.bodies) + row_bytes(w.constraints) +
         row_bytes(w.connections) + static_cast<double>(w.points.size() * sizeof(FreeMotion)) +
         static_cast<double>(w.bodies.size() * sizeof(Motion));
}

/// [bytes] of the lists of neighbours.
double list_bytes(const World& w) {
  std::size_t bytes = 0;
  if (w.forces)
    for (const ActingInteraction& acting : w.forces->interactions) bytes += acting.pairs.neighbours.memory();
  return static_cast<double>(bytes);
}

std::unique_ptr<Scene> open_big(const Big& big, int count) {
  SceneOptions options;
  options.threads = count;
  options.script_limit = 0.0;
  return lua::open_scene_text(big.source, "scale.lua", "", options);
}

/// [s] of the clock that `call` takes.
template <class Call>
double timed(Call call) {
  const double start = now(2);
  call();
  return now(2) - start;
}

struct Turn {
  std::unique_ptr<Scene> scene;
  double best = infinity;  ///< [s] of a window
};

void print_opening(const Big& big, Turn& turn) {
  malloc_trim(0);
  const double before = resident(), start = now();
  turn.scene = open_big(big, 1);
  const double opened = now() - start, after = resident();
  const double first = timed([&] { turn.scene->step(); });
  malloc_trim(0);
  const double stepped = resident();
  const World& world = turn.scene->world();
  const auto each = [&](double bytes) { return bytes / big.things; };
  std::printf(
      "opened in %.2f s, %.0f ns each; first step %.2f s\n"
      "bytes each: %.0f opened, of which %.0f rows; %.0f after a step, of which %.0f lists of neighbours\n",
      opened, 1e9 * opened / big.things, first, each(after - before), each(row_bytes(world)), each(stepped - before),
      each(list_bytes(world)));
}

void measure(const Big& big) {
  std::printf("\n%s\n", big.name);
  Turn turns[threads];
  print_opening(big, turns[0]);
  turns[1].scene = open_big(big, 2);
  turns[1].scene->step();
  for (int i = 0; i < windows; i++)  // by turns, so that what else the machine does meets both alike
    for (Turn& turn : turns) {
      const double seconds = timed([&] {
        for (int k = 0; k < window; k++) turn.scene->step();
      });
      turn.best = std::min(turn.best, seconds);
    }
  std::printf("%8s %12s %8s\n", "threads", "ms/step", "ratio");
  for (int k = 0; k < threads; k++) {
    const World& world = turns[k].scene->world();
    require(world.failure.empty(), world.failure);
    require(state_hash(world) == state_hash(turns[0].scene->world()), "the bits depend on the number of threads");
    std::printf("%8d %12.1f %8.2f\n", k + 1, 1e3 * turns[k].best / window, turns[0].best / turns[k].best);
  }
  std::fflush(stdout);
}

void bench_scale(const player::BenchOptions& options) {
  const auto asked = [&](const Big& big) {
    return options.arguments.empty() ||
           std::find(options.arguments.begin(), options.arguments.end(), big.argument) != options.arguments.end();
  };
  std::printf("Opening by one thread's processor time; steps by the clock, the best of %d times %d\n", windows, window);
  for (const Big& big : scenes)
    if (asked(big)) measure(big);
}

const player::Register scale_benchmark(
    {"scale",
     "a million particles, a million springs, 100,000 hinged bodies from Lua; arguments: particles, springs, bodies",
     bench_scale});

}  // namespace
