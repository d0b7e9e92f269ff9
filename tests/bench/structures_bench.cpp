// `pantin bench structures`: how long it takes to build a large lattice and many rods on hinges, and their first step.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "bench/clock.hpp"
#include "laws/library.hpp"
#include "player/bench.hpp"
#include "step/step.hpp"
#include "structures/build.hpp"
#include "structures/lattice.hpp"
#include "structures/polyhedra.hpp"

using namespace pantin;

namespace {

BuildLaw bench_spring() {
  LawArguments arguments;
  arguments.numbers["stiffness"] = 1.0;
  auto law = std::make_shared<const Law>(make_library_law("spring", arguments)[0]);
  std::vector<double> values;
  for (const Parameter& p : law->parameters) values.push_back(p.value);
  return {law, values};
}

void measure(const char* name, Structure (*make)(), BuildAs as) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double made = never, built = never, stepped = never;
  Built parts;
  std::size_t edges = 0;
  for (int i = 0; i < 3; i++) {
    World world;
    BuildDef def;
    def.as = as;
    def.edge = bench_spring();
    const double start = now();
    const Structure s = make();
    def.mass = static_cast<double>(s.vertices.size());
    const double before = now();
    parts = build(world, s, def);
    const double after = now();
    step(world);
    made = std::min(made, before - start);
    built = std::min(built, after - before);
    stepped = std::min(stepped, now() - after);
    edges = s.edges.size();
  }
  std::printf("%-22s %9zu %9zu %9zu %9zu %12.3f %9.3f %13.3f\n", name, parts.particles.size(), edges,
              parts.bodies.size(), parts.connections.size(), made, built, stepped);
}

void bench_structures(const player::BenchOptions&) {
  std::printf("%-22s %9s %9s %9s %9s %12s %9s %13s\n", "", "vertices", "edges", "bodies", "ties", "structure, s",
              "build, s", "first step, s");
  measure(
      "lattice, deformable",
      [] {
        return lattice("cubic", {46, 46, 46}, 1.0);
      },
      BuildAs::deformable);
  measure(
      "honeycomb, articulated",
      [] {
        return lattice("honeycomb", {30, 57, 1}, 1.0);
      },
      BuildAs::articulated);
  measure(
      "sheet, panels", [] { return shapes::sheet(70, 71, 1.0); }, BuildAs::panels);
}

const player::Register structures_benchmark(
    {"structures", "a lattice of 100,000 springs' ends, 10,000 rods and 5,000 plates on hinges", bench_structures});

}  // namespace
