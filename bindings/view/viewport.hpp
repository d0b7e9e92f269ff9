#pragma once
#include "view/camera.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// What a person sees: a world, through a camera, in a picture of that size [px].
struct Viewport {
  const World& world;
  const Stage& stage;
  const Camera& camera;
  int width = 0, height = 0;

  std::optional<Projected> project(Vec3 place) const {
    return finite(place) ? camera.project(place, width, height) : std::nullopt;
  }
  Vec3 place(double x, double y, double depth) const { return camera.place(x, y, depth, width, height); }
};

}  // namespace pantin
