#include "player/aim.hpp"

#include <cmath>

#include "measure/measure.hpp"

namespace pantin::player {

namespace {

constexpr double whole_turn = 6.283185307179586;  // [rad]

/// Whether a wish is for another place than the one before.
bool is_elsewhere(const CameraWish& before, CameraWish wish) {
  wish.follow = before.follow;
  wish.zoom = before.zoom;
  wish.ease = before.ease;
  return !(before == wish);
}

}  // namespace

Camera aim(const Scene& scene, const Stage& stage, double aspect) {
  Camera camera = first_camera(stage, aspect);
  CameraWish wish = scene.camera();
  Vec3 target = wish.look_at.value_or(camera.target);
  if (wish.at && norm(*wish.at - target) > 0.0)
    camera.look(*wish.at, target);
  else
    camera.target = target;
  camera.zoom(1.0 / wish.zoom);
  return camera;
}

Camera fit_to_size(const Camera& now, const Camera& aimed, double size_before, double size) {
  Camera camera = now;
  if (std::fabs(size - size_before) <= 0.1 * size_before) return camera;
  camera.target = aimed.target;
  camera.distance = aimed.distance;
  return camera;
}

void Follower::choose(AnyId thing) {
  chosen_ = thing;
  last_.reset();
}

void Follower::move(const Scene& scene, const Stage& stage, double aspect, double seconds, Camera& camera) {
  const CameraWish wish = scene.camera();
  const double part = wish.ease > 0.0 ? -std::expm1(-seconds / wish.ease) : 1.0;
  if (wished_ && is_elsewhere(*wished_, wish)) {
    goal_ = aim(scene, stage, aspect);
  } else if (wished_ && wished_->zoom != wish.zoom) {
    if (!goal_) goal_ = camera;
    goal_->zoom(wished_->zoom / wish.zoom);
  }
  wished_ = wish;
  if (goal_) go(*goal_, part, camera);
  follow(scene, part, camera);
}

/// By a part of the way.
void Follower::go(const Camera& goal, double part, Camera& camera) {
  camera.target += part * (goal.target - camera.target);
  camera.distance *= std::pow(goal.distance / camera.distance, part);
  camera.yaw += part * std::remainder(goal.yaw - camera.yaw, whole_turn);
  camera.pitch += part * (goal.pitch - camera.pitch);
  const double left = std::fabs(std::log(goal.distance / camera.distance)) + std::fabs(goal.pitch - camera.pitch) +
                      std::fabs(std::remainder(goal.yaw - camera.yaw, whole_turn)) +
                      norm(goal.target - camera.target) / camera.distance;
  if (left < 1e-3) goal_.reset();
}

/// What the scene wants followed with ease comes to the middle; else the camera keeps its place beside what it follows.
void Follower::follow(const Scene& scene, double part, Camera& camera) {
  const CameraWish wish = scene.camera();
  const AnyId thing = chosen_.value_or(wish.follow);
  if (std::holds_alternative<std::monostate>(thing) || !alive(scene.world(), thing)) return last_.reset();
  const Bounds box = bounds(scene.world(), things_of(scene.world(), thing));
  const Vec3 place = 0.5 * (box.low + box.high);
  if (!finite(place)) return;
  if (!chosen_ && wish.ease > 0.0) {
    camera.target += part * (place - camera.target);
    if (goal_) goal_->target = camera.target;
  } else if (last_) {
    camera.target += place - *last_;
    if (goal_) goal_->target += place - *last_;
  }
  last_ = place;
}

}  // namespace pantin::player
