#pragma once
#include <memory>
#include <vector>

#include "base/color.hpp"
#include "base/hash.hpp"
#include "view/stage.hpp"
#include "world/world.hpp"

namespace pantin {

/// How a body, or a shape of the world, is drawn, in its own frame [m].
struct Figure {
  struct Bar {
    Vec3 from = zero3(), to = zero3();
    double radius = 0.0;
    Color color;
  };
  struct Ball {
    Vec3 at = zero3();
    double radius = 0.0;
    Color color;
  };
  struct Ellipsoid {
    Vec3 at = zero3();
    Mat3 axes = zero33();  ///< half axes; the second is the axis of symmetry
    Color color;
  };
  struct Corner {
    Vec3 at = zero3(), normal = zero3();
    Color color;
  };
  struct PictureCorner {
    Vec3 at = zero3(), normal = zero3();
    Color color;
    float u = 0.0f, v = 0.0f;  ///< [pictures] from its left and its upper edge
  };
  /// A ball with pictures round its second axis.
  struct Globe {
    Ellipsoid shape;
    float around = 1.0f, down = 1.0f;  ///< [pictures] along its equator, from pole to pole
  };
  /// What shows one picture.
  struct Sheet {
    std::shared_ptr<const Picture> picture;
    std::vector<PictureCorner> corners;  ///< three for each triangle
    std::vector<Globe> globes;
  };
  std::vector<Sheet> sheets;
  std::shared_ptr<const Cover> sprite;  ///< shown instead of all else, where it is
  std::vector<Bar> bars;
  std::vector<Ball> balls;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Corner> corners;  ///< three for each triangle
  std::vector<double> joints;   ///< [m] (points of the body): radius that a hinge or nail there should exceed
  std::uint64_t hash = 0;       ///< of all that it was made from; figures of one hash are alike
};

/// A body's shapes as they are. Without any, points on a line become a capsule, in a plane a plate, in space their hull; an
/// inertia without such points an ellipsoid.
Figure make_figure(const World& world, BodyId body, const Stage& stage);
/// One of the world's shapes; of a plane, which is drawn as a floor, nothing.
Figure make_figure(const World& world, ShapeId shape);

/// Adds a shape, in the frame of its body; one with a picture to the sheets.
void add_shape(Figure& figure, const Shape& shape);
/// Of all that a shape's figure is made from.
void add_to(Hash& hash, const Shape& shape);

/// The figures of a world, made again only when a body's points, masses, shapes or colours change.
class Figures {
 public:
  const Figure& of(const World& world, BodyId body, const Stage& stage);
  const Figure& of(const World& world, ShapeId shape);
  void clear();

 private:
  std::vector<Figure> bodies_;  // (slots of bodies)
  std::vector<Figure> shapes_;  // (slots of shapes)
};

}  // namespace pantin
