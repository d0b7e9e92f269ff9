#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/color.hpp"
#include "base/handle.hpp"
#include "model/body.hpp"
#include "model/cover.hpp"
#include "shapes/shape.hpp"

namespace pantin {

/// What a shape is made of, where things touch it.
struct Material {
  double density = 1000.0;          ///< [kg/m³] > 0: of a body whose mass is not given
  double friction = 0.5;            ///< >= 0: of two shapes the root of the product
  double restitution = 0.0;         ///< 0 … 1: of two shapes the larger
  double rolling = 0.0;             ///< [m] >= 0: moment by normal force against rolling; of two shapes the larger
  double spinning = 0.0;            ///< [m] >= 0: the same against spinning on the spot
  Vec3 surface_velocity = zero3();  ///< [m/s] in the body's frame or the world: of a belt
};

/// A shape that a body has, or that stands in the world and does not move.
struct Shape {
  Geometry geometry = BallShape{0.5};
  Handle<Body> body;  ///< null: the world's
  Vec3 at = zero3();  ///< [m] of its origin, in the body's frame or the world
  Quat orientation;   ///< its axes to those
  Material material;
  std::uint32_t layer = 0;       ///< in Model::layers; 0: none
  bool sensor = false;           ///< tells what it touches, and pushes nothing
  Color color;                   ///< of one of the world's
  std::optional<double> extent;  ///< [m] across which a half space is drawn, about its origin; none: as the stage wants
  std::shared_ptr<const Cover> cover;  ///< null: its colour alone
  std::string name;
  std::uint64_t serial = 0;
};

using ShapeId = Handle<Shape>;

}  // namespace pantin
