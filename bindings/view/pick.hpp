#pragma once
#include "view/camera.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// The point nearest to a pixel, at most `reach` [px] from its ball's rim; of a hinge the point at which it is pulled. A
/// hinge wins against a lone point that is as near, and the nearer to the eye of two at one pixel. Null: none.
PointId pick_point(const World& world, const Stage& stage, const Camera& camera, double x, double y, int width,
                   int height, double reach = 40.0);
/// The same among hinges only.
ParticleId pick_hinge(const World& world, const Stage& stage, const Camera& camera, double x, double y, int width,
                      int height, double reach = 24.0);

/// The body, or else the shape of the world, that is seen at a pixel; sensors are seen through. Nothing: monostate.
AnyId pick_shape(World& world, const Camera& camera, double x, double y, int width, int height);

}  // namespace pantin
