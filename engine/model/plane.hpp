#pragma once
#include <array>
#include <string_view>

#include "base/lanes.hpp"

namespace pantin {

/// The plane that everything moves in, across one of the world's axes: each thing keeps its height, its coordinate along
/// that normal, and bodies turn about the normal alone. None: things move in space, and vectors are left as they are.
struct Plane {
  int normal = -1;  ///< axis across the plane: 0, 1, 2; -1: none

  bool flat() const { return normal >= 0; }
  double height(Vec3 position) const { return flat() ? position[normal] : 0.0; }
  /// 1 for each direction that things can move in, else 0.
  Vec3 directions() const { return along(vec(1, 1, 1)); }
  /// Without the part across the plane: of velocities, forces, arms.
  Vec3 along(Vec3 v) const {
    if (flat()) v[normal] = 0.0;
    return v;
  }
  /// The part about the normal: of spins, torques, angular momenta.
  Vec3 about(Vec3 v) const { return flat() ? v - along(v) : v; }
  /// A position at the height of another.
  Vec3 beside(Vec3 position, Vec3 other) const {
    if (flat()) position[normal] = other[normal];
    return position;
  }
  /// What a rotation turns about the normal.
  Quat about(const Quat& q) const {
    if (!flat()) return q;
    const Vec3 u = about(vec(q.x, q.y, q.z));
    return q.w * q.w + norm2(u) > 1e-12 ? normalised({q.w, u[0], u[1], u[2]}) : Quat{};
  }
  /// An axis that is the normal, or in the plane, up to round-off.
  Vec3 axis(Vec3 v) const {
    if (!flat()) return v;
    return direction(std::fabs(v[normal]) > 0.5 * norm(v) ? about(v) : along(v));
  }
};

/// Names of the planes by their normals.
inline constexpr std::array<std::string_view, 3> plane_names = {"yz", "xz", "xy"};

}  // namespace pantin
