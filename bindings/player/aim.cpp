#include "player/aim.hpp"

#include "measure/measure.hpp"

namespace pantin::player {

Camera aim(const Scene& scene, const Stage& stage, double aspect) {
  Camera camera = first_camera(stage, aspect);
  CameraWish wish = scene.camera();
  Vec3 target = wish.look_at.value_or(camera.target);
  if (wish.at && norm(*wish.at - target) > 0.0)
    camera.look(*wish.at, target);
  else
    camera.target = target;
  return camera;
}

void Follower::choose(AnyId thing) {
  chosen_ = thing;
  last_.reset();
}

void Follower::move(const Scene& scene, Camera& camera) {
  AnyId thing = chosen_.value_or(scene.camera().follow);
  if (std::holds_alternative<std::monostate>(thing) || !alive(scene.world(), thing)) return last_.reset();
  Bounds box = bounds(scene.world(), things_of(scene.world(), thing));
  Vec3 place = 0.5 * (box.low + box.high);
  if (last_ && finite(place)) camera.target += place - *last_;
  last_ = place;
}

}  // namespace pantin::player
