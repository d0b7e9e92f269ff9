#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "base/lanes.hpp"

namespace pantin {

/// A half line into the scene.
struct Ray {
  Vec3 from = zero3();             ///< [m]
  Vec3 direction = vec(0, 0, -1);  ///< of length 1
};

/// A place of the world in the picture.
struct Projected {
  double x = 0.0, y = 0.0;  ///< [px] from the upper left corner
  double depth = 0.0;       ///< [m] along the direction of view, > 0
  double pixel = 0.0;       ///< [m] size of a pixel at that depth
};

enum class Side : std::uint8_t { front, right, top };

/// Looks at `target` from `distance`, turned by `yaw` about the vertical and raised by `pitch`. All in double precision:
/// scenes may be 1e-9 m or 1e6 m wide. What is drawn is relative to the eye, in units of `distance`.
struct Camera {
  Vec3 target = zero3();  ///< [m]
  double distance = 6.0;  ///< [m] > 0
  double yaw = 0.35;      ///< [rad] 0 looks along -z
  double pitch = 0.22;    ///< [rad] -1.55 … 1.55
  double fov = 0.62;      ///< [rad] > 0, of the picture's height

  /// Turns by angles [rad].
  void orbit(double dx, double dy);
  /// Moves the target by parts of the picture's height, so that what lies there follows the pointer.
  void pan(double dx, double dy);
  /// Multiplies the distance; a factor below 1 goes nearer.
  void zoom(double factor);
  /// Zooms so that what is under the pixel stays there.
  void zoom_at(double factor, double x, double y, int width, int height);
  /// Keeps the angles and moves so that the box [m] fits the picture, whose width/height is `aspect`.
  void frame(Vec3 lower, Vec3 upper, double aspect);
  /// Looks from a place to another [m].
  void look(Vec3 from, Vec3 at);
  /// Looks along an axis from so far away that near and far things of a scene have one size, to 1 %. What is at the
  /// target keeps its size.
  void look_along(Side side);
  /// With the usual perspective again.
  void look_freely();

  Vec3 eye() const;      ///< [m]
  Vec3 forward() const;  ///< of length 1, as are right and up
  Vec3 right() const;
  Vec3 up() const;
  double nearest() const;  ///< [m] of depth: what is nearer is not seen

  /// Rotation from the world's axes to the camera's (x right, y up, z backward); acts on (place - eye) / distance.
  Eigen::Matrix4f view() const;
  Eigen::Matrix4f projection(double aspect) const;

  Ray ray(double x, double y, int width, int height) const;
  /// Place [m] seen at a pixel at a depth [m].
  Vec3 place(double x, double y, double depth, int width, int height) const;
  /// Nothing for places behind the eye.
  std::optional<Projected> project(Vec3 place, int width, int height) const;
};

}  // namespace pantin
