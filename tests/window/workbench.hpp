#pragma once
// A chain in a world, and hands before a picture of it that a test moves.
#include <string>
#include <vector>

#include "measure/query.hpp"
#include "step/step.hpp"
#include "view/player_input.hpp"
#include "window/small_worlds.hpp"

namespace pantin {

inline constexpr int width = 1280, height = 720;

/// A chain of rods that is nailed at its first point, and hands before a picture of it.
struct Workbench {
  World world;
  std::vector<BodyId> rods;
  Stage stage;
  Camera camera;
  std::int32_t hands = 0;
  PlayerInput person{[this] { return hands++; }};
  Gestures gestures;
  std::vector<std::string> said;

  explicit Workbench(int links = 4) : rods(small_worlds::chain(world, links)) {
    stage = find_stage(world);
    camera = first_camera(stage, static_cast<double>(width) / height);
  }
  PointId head(int rod) const { return world.bodies[rods[static_cast<std::size_t>(rod)]].points[0]; }
  PointId tail(int rod) const { return world.bodies[rods[static_cast<std::size_t>(rod)]].points[1]; }
  Projected seen(Vec3 position) const { return camera.project(position, width, height).value(); }
  Projected seen(PointId point) const { return seen(position(world, point)); }

  void event(PointerEvent::Kind kind, Projected at, PointerId id) {
    Pointer& pointer = gestures.pointers[id];
    PointerEvent e;
    e.kind = kind;
    e.button = kind == PointerEvent::Kind::move ? PointerEvent::Button::none : PointerEvent::Button::left;
    e.pointer = id;
    e.dx = at.x - pointer.x;
    e.dy = at.y - pointer.y;
    e.x = pointer.x = at.x;
    e.y = pointer.y = at.y;
    if (kind != PointerEvent::Kind::move) pointer.left = kind == PointerEvent::Kind::press;
    gestures.events.push_back(e);
  }
  void press(Projected at, PointerId id = 0) { event(PointerEvent::Kind::press, at, id); }
  void move(Projected at, PointerId id = 0) { event(PointerEvent::Kind::move, at, id); }
  void release(Projected at, PointerId id = 0) { event(PointerEvent::Kind::release, at, id); }
  /// A frame of some steps.
  void frame(int steps = 4) {
    const Actions actions =
        person.apply(gestures, {world, stage, width, height, false, 1.0 / 60.0, camera, world.input});
    said = actions.said;
    gestures.events.clear();
    gestures.keys.clear();
    for (int i = 0; i < steps; i++) step(world);
  }
  void choose(ToolKind kind, std::size_t variant = 0) { person.tool = {kind, variant}; }
  void drag(Projected from, Projected to, PointerId id = 0) {
    press(from, id);
    move({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}, id);
    move(to, id);
    release(to, id);
    frame(1);
  }
  void click(Projected at) {
    press(at);
    release(at);
    frame(1);
  }
  std::string last_log() const { return world.log.empty() ? "" : world.log.back().text; }
};
}  // namespace pantin
