#pragma once
#include "base/bounds.hpp"
#include "view/camera.hpp"
#include "world/world.hpp"

namespace pantin {

/// What is known of a scene's size from the world at its start; sets the default sizes of what is drawn, and the ground.
struct Stage {
  double unit = 1.0;     ///< [m] typical distance between points that belong together
  double size = 1.0;     ///< [m] largest edge of the box
  Vec3 lower = zero3();  ///< [m] box that holds the points and where what hangs on nails will swing
  Vec3 upper = zero3();  ///< [m]
  double ground = 0.0;   ///< [m] height of the ground, below the box
  bool empty = true;     ///< nothing was there yet
};

/// Of the stage's size: what is farther from its middle plays no more.
inline constexpr double far_away = 10.0;

/// A box of things with the world's own shapes, but for half spaces, so far as they are not farther from it than `margin` [m].
Bounds with_ground(const World& world, const Bounds& things, double margin);
Stage find_stage(const World& world);
/// A camera that sees the whole stage; `aspect` is width/height.
Camera first_camera(const Stage& stage, double aspect);

}  // namespace pantin
