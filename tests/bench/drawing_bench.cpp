// `pantin bench drawing`: what a frame of 1280 x 720 costs without samples, beside an empty one, and with 4.
#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bench/clock.hpp"
#include "edit/edit.hpp"
#include "player/bench.hpp"
#include "support/cases.hpp"
#include "view/renderer.hpp"
#include "view/window.hpp"
#include "window/pictured.hpp"

using namespace pantin;

namespace {

constexpr int width = 1280, height = 720, warm_frames = 1, rounds = 5, frames = 2;

void add_particles(World& world, int edge, FamilyId family = {}) {
  for (int i = 0; i < edge * edge * edge; i++) {
    ParticleDef def;
    def.at = vec(i % edge, i / edge % edge, i / (edge * edge)) * 0.5 + vec(0, 1, 0);
    def.radius = 0.12;
    def.family = family;
    def.color = {0.2f + 0.6f * static_cast<float>(i % edge) / static_cast<float>(edge), 0.45f, 0.7f, 1.0f};
    add_particle(world, def);
  }
}

void add_sprites(World& world, int edge) {
  FamilyDef family;
  family.name = "birds";
  family.sprite = std::make_shared<const Cover>(
      Cover{pictured::picture(64, 64, [](double x, double) { return x < 0.5 ? pictured::red : pictured::clear; }), 0.3,
            zero3(), zero3()});
  add_particles(world, edge, add_family(world, family));
}

/// 1000 rods in 50 chains, beside each other.
void add_chains(World& world) {
  for (int i = 0; i < 50; i++) cases::add_chain(world, {.links = 20, .length = 0.6, .start = vec(0, 6, 0.25 * i)});
}

struct DrawingCase {
  std::string name;
  Renderer renderer;
  World world = {};
  Camera camera = {};
  Overlay overlay = {};
  double wall = std::numeric_limits<double>::infinity(), processor = wall;  // [s] of a frame, least
};

void draw_some(DrawingCase& one) {
  for (int i = 0; i < warm_frames; i++) one.renderer.draw(one.world, one.camera, one.overlay);
  glFinish();
  const double start = now(2), start_processor = processor_time();
  for (int i = 0; i < frames; i++) one.renderer.draw(one.world, one.camera, one.overlay);
  glFinish();
  one.wall = std::min(one.wall, (now(2) - start) / frames);
  one.processor = std::min(one.processor, (processor_time() - start_processor) / frames);
}

void bench_drawing(const player::BenchOptions&) {
  const Window window("bench", width, height, true);
  std::vector<std::unique_ptr<DrawingCase>> cases_of;
  const auto add = [&](const char* name, void (*make)(World&), const Views& views, int samples = 0) {
    cases_of.push_back(std::unique_ptr<DrawingCase>(new DrawingCase{name, Renderer(width, height, samples)}));
    DrawingCase& one = *cases_of.back();
    one.overlay.views = views;
    make(one.world);
    one.renderer.open(one.world);
    one.camera = first_camera(one.renderer.stage(), static_cast<double>(width) / height);
  };
  const auto nothing = [](World&) {};
  const auto particles = [](World& world) { add_particles(world, 22); };
  const auto sprites = [](World& world) { add_sprites(world, 22); };
  const auto bodies = [](World& world) { add_chains(world); };
  const auto both = [](World& world) {
    add_particles(world, 22);
    add_chains(world);
  };
  add("empty", nothing, {});
  add("10,648 particles", particles, {});
  add("1000 hinged bodies", bodies, {});
  add("10,648 sprites", sprites, {});
  add("10,648 sprites, no shadows", sprites, {View::bodies, View::loads});
  add("both", both, {});
  add("both, without shadows", both, {View::bodies, View::loads});
  add("both, rings and velocities", both, {View::bodies, View::loads, View::shadows, View::rings, View::velocities});
  add("empty, 4 samples", nothing, {}, 4);
  add("both, 4 samples", both, {}, 4);
  for (int round = 0; round < rounds; round++)
    for (auto& one : cases_of) draw_some(*one);
  std::printf("%s; 1280 x 720, best of %d rounds of %d frames\n", glGetString(GL_RENDERER), rounds, frames);
  std::printf("%-28s %10s %14s %14s\n", "drawn", "ms/frame", "processor, ms", "of an empty's");
  for (const auto& one : cases_of)
    std::printf("%-28s %10.1f %14.1f %14.1f\n", one->name.c_str(), 1e3 * one->wall, 1e3 * one->processor,
                one->processor / cases_of.front()->processor);
}

const player::Register drawing_benchmark({"drawing", "10,000 particles and 1000 hinged bodies drawn", bench_drawing});

}  // namespace
