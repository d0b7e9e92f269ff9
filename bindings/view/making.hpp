#pragma once
#include <optional>
#include <vector>

#include "view/viewport.hpp"
#include "world/input.hpp"

namespace pantin {

/// A drag with the tool that makes things, as it is now.
struct MakingDrag {
  std::size_t variant = 0;                      ///< of the tool
  double x0 = 0.0, y0 = 0.0, x = 0.0, y = 0.0;  ///< [px] of the press, and now
  bool click = false;                           ///< too short for a size: it is the usual one
  bool snaps = false;                           ///< to the grid
  double depth = 0.0;                           ///< [m] of the press
  PointId point;                                ///< at which it began, or null
  BodyId body;                                  ///< the same where that has no point there
  Vec3 start = zero3();                         ///< [m] where it began
};

/// What it makes, with numbers that can be read: multiples of some hundredth of the scene's unit, a power of ten.
Command made_by_drag(const Viewport& viewport, const MakingDrag& drag);

/// A polygon over an outline [m], as thick as usual things are, across the plane or the view.
Command made_of_outline(const Viewport& viewport, std::vector<Vec3> outline);
/// The corners of an outline that was drawn [m], but for those that a line between others misses by less than some pixels.
std::vector<Vec3> corners_of_stroke(const Viewport& viewport, const std::vector<Vec3>& stroke);
/// The axis of the world that points most to the viewer, about which hinges turn; in a plane 0.
Vec3 hinge_axis(const Viewport& viewport);

/// [m] Distance of the lines of the grid that is drawn and snapped to while its key is held: ten times the numbers' last digit.
double grid_of(const Viewport& viewport);
/// [m] What a pixel shows of the scene's plane, or else at the depth of what is looked at, to the numbers' last digit or on
/// the grid.
Vec3 place_to_make(const Viewport& viewport, double x, double y, bool snaps);
/// Left to right, along an axis of the world: what is mirrored along it.
Vec3 mirror_of(const Viewport& viewport);

/// [m] Where a pixel's line meets the plane of a world that has one.
std::optional<double> depth_of_plane(const Viewport& viewport, double x, double y);
/// The same of a parallel plane through a place.
std::optional<double> depth_of_plane(const Viewport& viewport, double x, double y, Vec3 through);
/// [m] What a pixel shows of the scene's plane, else of the plane through the camera's target that faces the eye.
Vec3 place_pointed_at(const Viewport& viewport, double x, double y);

}  // namespace pantin
