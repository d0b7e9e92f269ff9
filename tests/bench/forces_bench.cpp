// `pantin bench forces`: laws of Lua scenes, as whole steps of the engine, against loops by hand and against LAMMPS.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "bench/by_hand.hpp"
#include "bench/clock.hpp"
#include "bench/lammps.hpp"
#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/program.hpp"
#include "laws/run/bonds.hpp"
#include "laws/run/pair_code.hpp"
#include "lua/scene/open.hpp"
#include "player/bench.hpp"
#include "scene/scene.hpp"
#include "support/process.hpp"

using namespace pantin;

namespace {

constexpr int melt_steps = 100, rounds = 5;

constexpr const char* lennard_jones = "function(r) return 4 * (r^-12 - r^-6) end";
constexpr const char* four_attributes = R"(function(r, a, b)
  local s = (a.size + b.size) / r
  return 4 * a.depth * b.depth * (s^12 - s^6)
end)";
constexpr const char* smooth_switch = R"(function(r)
  local s = 2 * math.max(r - 2, 0)
  return 4 * (r^-12 - r^-6) * (1 - s^3 * (10 - s * (15 - 6 * s)))
end)";
constexpr const char* called = R"(function(r)
  if r == 0 then return 0 end
  return 4 * (r^-12 - r^-6)
end)";

/// Atoms of LAMMPS' melt in a scene with a potential of its own.
std::unique_ptr<Scene> open_melt(const cases::Melt& melt, const std::string& potential, int threads) {
  SceneOptions options;
  options.threads = threads;
  const std::string source = text("scene.gravity = vec(0, 0, 0) scene.step = 0.005 local edge = ", melt.edge,
                                  R"( scene.box = vec(edge, edge, edge)
local atoms = scene:family("atoms", { attributes = { size = 0.5, depth = 1 } })
scene:interact(atoms, atoms, force.pair { cutoff = 2.5, shift = false, potential = )",
                                  potential, " })");
  auto scene = lua::open_scene_text(source, "melt.lua", "", options);
  World& world = scene->world();
  set_box(world, vec(melt.edge, melt.edge, melt.edge));  // to the last digit
  ParticleDef atom;
  atom.family = world.families.ids().front();
  for (std::size_t i = 0; i < melt.positions.size(); i++) {
    atom.at = melt.positions[i];
    atom.velocity = melt.velocities[i];
    add_particle(world, atom);
  }
  scene->step();
  return scene;
}

void run(Scene& scene, int steps) {
  for (int i = 0; i < steps; i++) scene.step();
  require(scene.world().failure.empty(), scene.world().failure);
}

/// The fastest of runs of `melt_steps` steps of the engine from the melt's start.
struct EngineRun {
  double seconds = infinity;  ///< [s] of the thread's processor
  double clock = infinity;    ///< [s]
  Profile profile;            ///< of the fastest by the clock
};

void improve(EngineRun& best, const cases::Melt& melt, const char* potential, int threads) {
  const auto scene = open_melt(melt, potential, threads);
  const Profile before = scene->world().profile;
  const double start = now(), clock = now(2);
  run(*scene, melt_steps);
  best.seconds = std::min(best.seconds, now() - start);
  if (now(2) - clock >= best.clock) return;
  best.clock = now(2) - clock;
  best.profile = scene->world().profile;
  for (std::size_t k = 0; k < before.ns.size(); k++) best.profile.ns[k] -= before.ns[k];
}

struct MeltCase {
  const char* name;
  const char* potential;
  by_hand::Law hand;
  double hand_seconds = infinity;
  EngineRun alone, shared;  // one thread, two
};

void print_row(const char* name, double seconds, double atoms, double against) {
  std::printf("%-44s %8.2f %8.1f", name, atoms * melt_steps / seconds * 1e-6, seconds / melt_steps / atoms * 1e9);
  if (against > 0.0) std::printf(" %8.2f", against / seconds);
  std::printf("\n");
}

void print_phases(const Profile& profile, double atoms) {
  std::printf("  by the clock, ns:");
  for (std::size_t k = 0; k < phase_names.size(); k++) {
    const double ns = static_cast<double>(profile.ns[k]) / melt_steps / atoms;
    if (ns >= 0.05) std::printf(" %s %.1f", std::string(phase_names[k]).c_str(), ns);
  }
  std::printf("\n");
}

void print_memory(const cases::Melt& melt, const MeltCase& of) {
  const auto scene = open_melt(melt, of.potential, 1);
  const ActingInteraction& acting = scene->world().forces->interactions.front();
  const auto n = static_cast<double>(melt.positions.size()),
             pairs = static_cast<double>(acting.pairs.neighbours.pairs()),
             bytes = static_cast<double>(acting.pairs.neighbours.memory());
  const Program program = lower(acting.law->graph, acting.law->force);
  const double start = now();
  const auto code = PairCode::of(*acting.law, program);
  const double writing = code ? now() - start : 0.0;
  std::printf(
      "%s: %zu operations for the force, written as code in %.0f µs; %.1f pairs a particle; rows take %.2f bytes a "
      "pair, %.0f a particle\n",
      of.name, program.operations(), writing * 1e6, pairs / n, bytes / pairs, bytes / n);
}

void bench_melts(bool peers) {
  const cases::Melt melt;
  const auto atoms = static_cast<double>(melt.positions.size());
  std::vector<MeltCase> list = {{"Lennard-Jones", lennard_jones, by_hand::Law::lennard_jones, infinity, {}, {}},
                                {"four attributes", four_attributes, by_hand::Law::four_attributes, infinity, {}, {}},
                                {"smooth switch", smooth_switch, by_hand::Law::smooth_switch, infinity, {}, {}}};
  double cut = infinity, cut_opt = infinity, safe = infinity;
  for (int round = 0; round < rounds; round++) {
    if (peers) {
      cut = std::min(cut, run_lammps("", lammps_blind_lists));
      cut_opt = std::min(cut_opt, run_lammps("opt", lammps_blind_lists));
      safe = std::min(safe, run_lammps("", lammps_safe_lists));
    }
    for (MeltCase& of : list) {
      of.hand_seconds = std::min(of.hand_seconds, by_hand::run_melt(melt, melt_steps, of.hand));
      improve(of.alone, melt, of.potential, 1);
      improve(of.shared, melt, of.potential, 2);
    }
  }
  std::printf("Melt of %.0f atoms, %d whole steps, best of %d rounds; one thread by its processor time\n", atoms,
              melt_steps, rounds);
  std::printf("%-44s %8s %8s %8s\n", "", "M/s", "ns", "ratio");
  if (peers) {
    print_row("LAMMPS lj/cut, list every 20 unchecked", cut, atoms, 0.0);
    print_row("LAMMPS lj/cut/opt, the same, to lj/cut", cut_opt, atoms, cut);
    print_row("LAMMPS lj/cut, list as atoms move, to lj/cut", safe, atoms, cut);
    print_row("Lua Lennard-Jones, to LAMMPS lj/cut", list[0].alone.seconds, atoms, cut);
    print_row("Lua Lennard-Jones, to LAMMPS lj/cut/opt", list[0].alone.seconds, atoms, cut_opt);
    print_row("Lua Lennard-Jones, to lj/cut, list as it moves", list[0].alone.seconds, atoms, safe);
  }
  for (const MeltCase& of : list) {
    print_row(text(of.name, " by hand").c_str(), of.hand_seconds, atoms, 0.0);
    print_row(text(of.name, " in Lua, to that by hand").c_str(), of.alone.seconds, atoms, of.hand_seconds);
    print_phases(of.alone.profile, atoms);
    print_row(text(of.name, " in Lua, 2 threads by the clock, to 1").c_str(), of.shared.clock, atoms, of.alone.clock);
  }
  for (const MeltCase& of : list) print_memory(melt, of);
}

/// [s] of a call of the same function by a loop in Lua, on plain numbers and without its derivative.
double time_plain_call() {
  constexpr int calls = 1000000;
  const std::string source =
      text("local law, sum = ", called, ", 0 for i = 1, ", calls, " do sum = sum + law(0.9 + i * 1e-6) end");
  const double start = now();
  lua::open_scene_text(source, "loop.lua", "", {});
  return (now() - start) / calls;
}

void bench_called() {
  const cases::Melt melt(10);
  double best = infinity, plain = infinity;
  std::size_t pairs = 0;
  for (int round = 0; round < rounds; round++) {
    const auto scene = open_melt(melt, called, 1);
    const double start = now();
    run(*scene, 10);
    best = std::min(best, (now() - start) / 10.0);
    pairs = scene->world().forces->interactions.front().pairs.neighbours.pairs();
    plain = std::min(plain, time_plain_call());
  }
  const auto atoms = static_cast<double>(melt.positions.size());
  std::printf(
      "Lennard-Jones that cannot be traced, called in Lua for each pair: %.0f atoms, %.2f M atom-steps/s, "
      "%.0f ns a pair of the rows; a call of the function by a loop in Lua, without its derivative: %.0f ns\n",
      atoms, atoms / best * 1e-6, best / static_cast<double>(pairs) * 1e9, 1e9 * plain);
}

constexpr std::uint32_t lattice = 70;

/// A cubic lattice of springs with positions, stiffnesses and lengths a little off.
BondList make_lattice(Sites& sites) {
  Random random{7};
  const auto off = [&] { return 0.4 * random.uniform() - 0.2; };
  sites.resize(std::size_t{lattice} * lattice * lattice);
  sites.clear_forces();
  BondList ties;
  ties.parameters.resize(2);
  for (std::uint32_t i = 0; i < sites.n; i++) {
    const std::uint32_t x = i % lattice, y = i / lattice % lattice, z = i / (lattice * lattice);
    sites.x[i] = vec(x + off(), y + off(), z + off());
    for (const auto& [along, step] : {std::pair{x, 1u}, std::pair{y, lattice}, std::pair{z, lattice * lattice}}) {
      if (along + 1 == lattice) continue;
      ties.sites.push_back(i);
      ties.sites.push_back(i + step);
      ties.parameters[0].push_back(10.0 + off());
      ties.parameters[1].push_back(1.0 + off());
    }
  }
  return ties;
}

/// The law that a scene makes of a Lua function.
std::shared_ptr<const Law> lua_spring() {
  const auto scene = lua::open_scene_text(
      R"(local function at(x) return scene:particle { at = vec(x, 0, 0) } end
scene:connect(at(0), at(1), force.pair { parameters = { stiffness = 10, length = 1 },
  potential = function(r, a, b, own) return 0.5 * own.stiffness * (r - own.length)^2 end }))",
      "springs.lua", "", {});
  const World& world = scene->world();
  return world.connections[world.connections.ids().front()].law;
}

double difference(const AlignedVector<Vec3>& a, const AlignedVector<Vec3>& b) {
  double sum = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) {
    sum += norm2(a[i] - b[i]);
    scale += norm2(b[i]);
  }
  return std::sqrt(sum / scale);
}

/// Seconds of the fastest of many runs, each after one of the others.
template <class... Runs>
std::vector<double> best_of(int times, Runs... runs) {
  std::vector<double> best(sizeof...(runs), infinity);
  for (int i = 0; i < times; i++) {
    std::size_t k = 0;
    ((best[k] = std::min(best[k], runs()), k++), ...);
  }
  return best;
}

void bench_springs() {
  Sites sites;
  const BondList ties = make_lattice(sites);
  const auto law = lua_spring();
  Workers one(1), two(2);
  Bonds alone(law, {}, one), shared(law, {}, two);
  BondList of_law = ties;
  if (law->parameters[0].name == "length") std::swap(of_law.parameters[0], of_law.parameters[1]);
  alone.arrange(of_law, sites);
  shared.arrange(of_law, sites);
  by_hand::add_springs(sites, ties);
  const AlignedVector<Vec3> expected = sites.force;
  sites.clear_forces();
  alone.add_forces(sites, {}, {}, {}, one);
  const double wrong = difference(sites.force, expected);
  const auto timed = [](int threads, auto call) {
    const double start = now(threads);
    call();
    return now(threads) - start;
  };
  const auto with_one = [&] { alone.add_forces(sites, {}, {}, {}, one); };
  const std::vector<double> best = best_of(
      10 * rounds, [&] { return timed(1, [&] { by_hand::add_springs(sites, ties); }); },
      [&] { return timed(1, with_one); }, [&] { return timed(2, with_one); },
      [&] { return timed(2, [&] { shared.add_forces(sites, {}, {}, {}, two); }); });
  const auto n = static_cast<double>(ties.size());
  std::printf(
      "%.0f springs of a Lua law: %.1f M/s by hand, %.1f M/s in Lua (ratio %.2f), with 2 threads by the clock "
      "%.2f times 1; forces differ by %.1e\n",
      n, n / best[0] * 1e-6, n / best[1] * 1e-6, best[0] / best[1], best[2] / best[3], wrong);
}

/// Seconds of a step of a steady stream, the fastest of some runs of steps, one thread.
double time_stream(int alive, const char* laws) {
  SceneOptions options;
  options.threads = 1;
  const auto scene = lua::open_scene_text(text("local alive, lifetime = ", alive, R"(, 3
scene.step, scene.gravity = 0.01, vec(0, 0, 0)
local drops = scene:family("drops", { mass = 1 })
scene:emitter { family = drops, at = { vec(-10, -10, -10), vec(10, 10, 10) }, rate = alive / lifetime,
  velocity = vec(0, 1, 0), lifetime = lifetime }
)",
                                               laws),
                                          "stream.lua", "", options);
  run(*scene, 301);
  double best = infinity;
  for (int round = 0; round < 3 * rounds; round++) {
    const double start = now();
    run(*scene, 10);
    best = std::min(best, (now() - start) / 10.0);
  }
  require(scene->world().particles.size() + 1000 > static_cast<std::size_t>(alive), "the stream is not steady");
  return best;
}

void bench_streams() {
  constexpr int alive = 100000;
  constexpr const char* field =
      "scene:field(drops, force.point { potential = function(p) return p.position:dot(p.position) end })";
  constexpr const char* pairs =
      "scene:interact(drops, drops, force.pair { cutoff = 1, potential = function(r) return (1 - r)^2 end })";
  std::printf(
      "%d particles, of which a step makes and ends %d: %.2f ms a step without a law, %.2f with a field, "
      "%.2f with one between pairs\n",
      alive, alive / 300, 1e3 * time_stream(alive, ""), 1e3 * time_stream(alive, field),
      1e3 * time_stream(alive, pairs));
}

void bench_forces(const player::BenchOptions& options) {
  bool peers = options.peers;
  if (peers && !support::have_program("lmp")) {
    std::printf("LAMMPS is not here: there is no program 'lmp' (Debian: lammps)\n");
    peers = false;
  }
  const auto asked = [&](const char* part) {
    const auto& list = options.arguments;
    return list.empty() || std::find(list.begin(), list.end(), part) != list.end();
  };
  if (asked("melts")) bench_melts(peers);
  if (asked("called")) bench_called();
  if (asked("springs")) bench_springs();
  if (asked("streams")) bench_streams();
}

const player::Register forces_benchmark(
    {"forces", "laws of Lua scenes; with --peers, LAMMPS too; arguments: melts, called, springs, streams",
     bench_forces});

}  // namespace
