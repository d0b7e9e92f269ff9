#include "view/camera_moves.hpp"

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

void see_all(const World& world, const Stage& stage, double aspect, Camera& camera) {
  const std::optional<Vec3>& edges = world.settings.box;
  const Bounds box = edges ? Bounds{zero3(), *edges} : bounds(world, everything(world));
  const Vec3 margin = vec(1, 1, 1) * (0.12 * stage.unit);
  camera.frame(box.low - margin, box.high + margin, aspect);
}

}  // namespace pantin
