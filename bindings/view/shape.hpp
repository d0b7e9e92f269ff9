#pragma once
#include <vector>

#include "base/color.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// How a body is drawn, in its own frame [m].
struct Shape {
  struct Bar {
    Vec3 from = zero3(), to = zero3();
    double radius = 0.0;
  };
  struct Ball {
    Vec3 at = zero3();
    double radius = 0.0;
    Color color;
  };
  struct Ellipsoid {
    Vec3 at = zero3();
    Mat3 axes = zero33();  ///< half axes; the second is the axis of symmetry
  };
  struct Corner {
    Vec3 at = zero3(), normal = zero3();
  };
  std::vector<Bar> bars;
  std::vector<Ball> balls;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Corner> corners;  ///< three for each triangle
  Color color;
  std::vector<double> joints;  ///< [m] (points of the body): radius that a hinge or nail there should exceed
  std::uint64_t hash = 0;      ///< of all that it was made from; shapes of one hash are alike
};

/// Points on a line become a capsule, in a plane a plate, in space their hull; an inertia without such points an ellipsoid.
Shape make_shape(const World& world, BodyId body, const Stage& stage);

/// The shapes of a world's bodies, made again only when a body's points, masses or colours change.
class Shapes {
 public:
  const Shape& of(const World& world, BodyId body, const Stage& stage);
  void clear() { rows_.clear(); }

 private:
  std::vector<Shape> rows_;  // (slots of bodies)
};

}  // namespace pantin
