#include "view/camera_moves.hpp"

#include <algorithm>
#include <cmath>

#include "measure/measure.hpp"

namespace pantin {

using Kind = PointerEvent::Kind;

void move_camera(const Gestures& gestures, const PointerEvent& event, bool on_panel, int width, int height,
                 Camera& camera) {
  if (event.kind == Kind::wheel && !on_panel) camera.zoom_at(std::pow(0.88, event.dy), event.x, event.y, width, height);
  const auto found = gestures.pointers.find(event.pointer);
  if (event.kind != Kind::move || found == gestures.pointers.end()) return;
  const Pointer& pointer = found->second;
  if (pointer.middle || (pointer.right && event.shift))
    camera.pan(event.dx / height, event.dy / height);
  else if (pointer.right)
    camera.orbit(-event.dx / height * 3.0, event.dy / height * 3.0);
}

namespace {

Things that_play(const World& world, const Stage& stage) {
  const Vec3 middle = 0.5 * (stage.lower + stage.upper);
  const auto is_far = [&](Vec3 x) { return norm(x - middle) > far_away * stage.size; };
  Things things = everything(world);
  std::erase_if(things.bodies, [&](BodyId body) { return is_far(world.motion_of(body).x); });
  std::erase_if(things.free_points, [&](PointId point) { return is_far(position(world, point)); });
  return things;
}

/// The things with the place that they play in: walls, the ground, and floors right below or beside them.
Bounds with_place(const World& world, const Things& things, double margin) {
  const Bounds box = bounds(world, things);
  Bounds all = with_ground(world, box, margin);
  const Vec3 middle = 0.5 * (box.low + box.high);
  for (const ShapeId id : world.shapes.ids()) {
    const Shape& shape = world.shapes[id];
    if (shape.body || !std::holds_alternative<HalfSpaceShape>(shape.geometry)) continue;
    const Vec3 normal = matrix(shape.orientation)[2], foot = middle - normal * dot(middle - shape.at, normal);
    if (norm(foot - middle) <= margin + 0.5 * norm(box.high - box.low)) all.add(foot);
  }
  return all;
}

bool sees_the_same(const Camera& a, const Camera& b) {
  return norm(a.target - b.target) + std::fabs(a.distance - b.distance) < 1e-9 * a.distance;
}

}  // namespace

void see_all(const World& world, const Stage& stage, double aspect, Camera& camera) {
  const std::optional<Vec3>& edges = world.settings.box;
  const Vec3 margin = vec(1, 1, 1) * (0.12 * stage.unit);
  const double margin_of_place = 0.5 * stage.size;
  const auto framed = [&](const Bounds& box) {
    Camera to = camera;
    to.frame(box.low - margin, box.high + margin, aspect);
    return to;
  };
  const Things all = everything(world), near = that_play(world, stage);
  const bool some_are_far = all.bodies.size() + all.free_points.size() > near.bodies.size() + near.free_points.size();
  const bool some_are_near = near.bodies.size() + near.free_points.size() > 0;
  if (edges || !some_are_far || !some_are_near) {
    camera = framed(edges ? Bounds{zero3(), *edges} : with_place(world, all, margin_of_place));
    return;
  }
  const Camera to = framed(with_place(world, near, margin_of_place));
  camera = sees_the_same(camera, to) ? framed(bounds(world, all)) : to;
}

}  // namespace pantin
