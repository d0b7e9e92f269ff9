// `pantin bench start`: from a start of the window to its first picture.
#include <SDL.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "bench/clock.hpp"
#include "player/bench.hpp"
#include "player/home.hpp"
#include "player/player.hpp"

using namespace pantin;

namespace {

constexpr int rounds = 5;

struct Start {
  double wall, processor;  // [s]
};

/// From nothing to the first picture of a scene, or of the browser where the name is empty.
Start first_picture(const std::string& scene, const std::string& home) {
  player::RunOptions options;
  options.size = {1280, 720};
  const double start = now(2), start_processor = processor_time();
  player::Player player(scene.empty() ? "" : player::find_scene(scene, home), options, home);
  player.frame();
  glFinish();
  return {now(2) - start, processor_time() - start_processor};
}

void bench_start(const player::BenchOptions&) {
  SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, "offscreen", SDL_HINT_OVERRIDE);
  const std::string home = player::find_home();
  std::printf("1280 x 720, the least of %d starts in one process\n", rounds);
  std::printf("%-12s %10s %14s\n", "", "ms", "processor, ms");
  for (const char* scene : {"chain", ""}) {
    Start least = first_picture(scene, home);
    for (int i = 1; i < rounds; i++) {
      const Start one = first_picture(scene, home);
      least = {std::min(least.wall, one.wall), std::min(least.processor, one.processor)};
    }
    std::printf("%-12s %10.0f %14.0f\n", *scene ? scene : "all scenes", 1e3 * least.wall, 1e3 * least.processor);
  }
}

const player::Register start_benchmark({"start", "from a start to the first picture", bench_start});

}  // namespace
