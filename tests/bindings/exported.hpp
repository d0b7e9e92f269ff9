#pragma once
// Scenes that are written to files frame by frame.
#include <memory>
#include <string>

#include "lua/scene/open.hpp"
#include "scene/scene.hpp"

namespace pantin::exported {

inline std::unique_ptr<Scene> opened(const std::string& source) {
  return lua::open_scene_text(source, "test.lua", ".", {});
}

// A rod that flies and turns by 90 degrees in a second, and a mote that lives for half of it.
inline std::unique_ptr<Scene> thrown_rod() {
  return opened(R"(
    scene.gravity = vec(0, 0, 0)
    local fireflies = scene:family("fire flies", { color = "#f00", radius = 0.25 })
    scene:body { name = "thrown", mass = 1, inertia = vec(1, 1, 1), at = vec(1, 2, 3), velocity = vec(1, 0, 0),
                 spin = vec(0, 0, math.pi / 2), points = { vec(0, 0, 0), vec(1, 0, 0) } }
    scene:particle { name = "mote", family = fireflies, mass = 2, at = vec(0, 5, 0), velocity = vec(0, 0, 2),
                     lifetime = 0.5 })");
}

// Larger and redder with age.
inline std::unique_ptr<Scene> growing_mote() {
  return opened(R"(
    scene.gravity = vec(0, 0, 0)
    scene:particle { radius = function(age) return 0.1 + age end, color = function(age) return { age, 1, 0, 1 } end })");
}

template <class Frames>
void run(Scene& scene, double until, Frames& frames) {
  frames.add_frames(scene.world());
  while (scene.world().time < until - 0.5 * scene.world().settings.step) {
    scene.step();
    frames.add_frames(scene.world());
  }
}

}  // namespace pantin::exported
