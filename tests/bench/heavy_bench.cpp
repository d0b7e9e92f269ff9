// `pantin bench heavy`: error and time of a chain with a ball of 50,000 times a link's mass.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "bench/clock.hpp"
#include "measure/measure.hpp"
#include "player/bench.hpp"
#include "player/machine.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"

using namespace pantin;

namespace {

constexpr int links = 19;
constexpr double ratio = 5e4, end = 2.0;  // [s]

struct HeavyRun {
  double error = 0.0;                                        ///< [m] of the ball's centre at the end
  double gap = 0.0;                                          ///< [m] the largest until then
  double seconds = std::numeric_limits<double>::infinity();  ///< [s] that the steps take
};

HeavyRun run_heavy(double rate, Eigen::Vector2d position) {
  HeavyRun run;
  for (int repetition = 0; repetition < 9; repetition++) {
    World world;
    world.settings.step = 1.0 / rate;
    const BodyId ball = cases::add_heavy_chain(world, links, ratio).bodies.back();
    const double start = now();
    advance(world, end);
    run.seconds = std::min(run.seconds, now() - start);
    run.error = norm(world.motion_of(ball).x - vec(position.x(), position.y(), 0));
    run.gap = world.worst.hinge_gap;
  }
  return run;
}

void bench_heavy(const player::BenchOptions&) {
  const reference::PlaneChain plane = reference::heavy_plane_chain(links, ratio);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, end, 2000), links);
  std::printf("%d links and a ball of %g times a link's mass, %g s from horizontal, one thread's processor time\n",
              links, ratio, end);
  std::printf("%8s %12s %12s %14s %14s\n", "step, s", "error, m", "gap, m", "us per 1/60 s", "3x3 products");
  for (const double rate : {60.0, 120.0, 240.0, 480.0}) {
    const HeavyRun run = run_heavy(rate, position);
    const double frame = 1e9 * run.seconds / (60.0 * end);  // [ns]
    std::printf("   1/%-3g %12.2e %12.1e %14.2f %14.0f\n", rate, run.error, run.gap, frame / 1e3,
                frame / player::product_time());
  }
}

const player::Register heavy_benchmark({"heavy", "error and time of a chain with a ball of 50,000 times a link's mass",
                                        bench_heavy});

}  // namespace
