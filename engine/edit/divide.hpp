#pragma once
// A body that becomes several, which move on as its parts did.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/common.hpp"
#include "edit/parts.hpp"
#include "shapes/hull.hpp"

namespace pantin::internal {

/// [m] from a convex shape to a position of the world; 0 in it.
double distance_to(const Geometry& shape, const Pose& pose, Vec3 at);

/// A shape of a part: one that the body has, or a piece of it.
struct PartShape {
  ShapeId of;
  std::optional<Geometry> piece = {};  ///< in axes of its own, which are those of `of`; none: the whole
  Vec3 at = zero3();                   ///< [m] of its origin, in the axes of `of`
  double denser = 1.0;                 ///< by which its material is: a hull in what is round has to weigh as much
};
/// Of a hull in the axes of `of`: with its origin at its centre of mass.
PartShape piece_of(ShapeId of, const Hull& hull, double denser);

struct Part {
  std::string called;  ///< in errors
  std::vector<PointId> points;
  std::vector<PartShape> shapes;
};

/// Whether a body's own mass is that of its shapes, each filled evenly.
bool is_filled(const World& world, BodyId body);

/// Makes bodies of all parts, in the same frame; each moves as it did. With `keeps` the body lives on as the first, else it
/// is gone. Own mass that is not that of shapes is the first part's. Throws Error, with the world as it was, where a part
/// cannot be a body.
std::vector<BodyId> divide(World& world, BodyId body, const std::vector<Part>& parts, bool keeps,
                           const std::string& call);

}  // namespace pantin::internal
