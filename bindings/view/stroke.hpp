#pragma once
#include <optional>
#include <vector>

#include "view/viewport.hpp"

namespace pantin {

/// A move of a pointer from one pixel to another, or a click where they are the same.
struct Stroke {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;  ///< [px]
};

/// Hinges, connections and the constraints that a hand may cut, where a stroke crosses; of those at its click's place the nearest.
/// What hands hold by is not among them.
std::vector<AnyId> cuttable(const Viewport& viewport, const Stroke& stroke);
/// Where such a thing is seen: one place of a hinge or nail, the two ends of a tie [m].
struct Seen {
  Vec3 from = zero3(), to = zero3();
  bool tie = false;
};
Seen seen_place(const Viewport& viewport, const AnyId& thing);

/// The body whose outline a pixel is in or at most `reach` [px] from; the nearest to the eye of several. Null: none.
BodyId pick_body(const Viewport& viewport, double x, double y, double reach = 12.0);
/// The place on a shape that is seen at a pixel.
struct OnShape {
  BodyId body;         ///< null: the world
  Vec3 at = zero3();   ///< [m]
  double depth = 0.0;  ///< [m] along the view
};
std::optional<OnShape> pick_shape(const Viewport& viewport, double x, double y);
/// What one can take hold of at a pixel: a point, or a place on a body that has none there.
struct Held {
  PointId point;
  BodyId body;        ///< of the place; null where there is a point
  Vec3 at = zero3();  ///< [m] the place
  explicit operator bool() const { return point || body; }
};
/// As `pick_point`, or else the place on the shape there, or else the seen point of the body there that is nearest.
Held pick_held(const Viewport& viewport, double x, double y);
/// Where it is shown [m].
Vec3 shown_place(const World& world, const Held& held);
/// The body, free particle, connection or constraint at a pixel, or nothing.
AnyId pick_thing(const Viewport& viewport, double x, double y);

}  // namespace pantin
