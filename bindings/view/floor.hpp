#pragma once
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// The part of one of the world's planes that is drawn.
struct Floor {
  Vec3 middle = zero3();  ///< [m]
  double reach = 1.0;     ///< [m]
};
Floor floor_of(const World& world, ShapeId plane, const Stage& stage);
/// The same where a camera looks at `target` [m] from so far away [m]: what has no size goes along with it.
Floor floor_seen(const World& world, ShapeId plane, const Stage& stage, Vec3 target, double distance);
/// Edge of the squares that the ground shows [m]: a round number.
double ground_square(const Stage& stage);

}  // namespace pantin
