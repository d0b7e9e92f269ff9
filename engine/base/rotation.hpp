#pragma once
// Quaternions of turns.
#include "base/functions.hpp"
#include "base/lanes.hpp"

namespace pantin {

/// Of a turn by an angle [rad] about an axis of unit length.
inline Quat quaternion_of(Vec3 axis, double angle) {
  const Vec3 u = axis * functions::sin(0.5 * angle);
  return {functions::cos(0.5 * angle), u[0], u[1], u[2]};
}
/// Of a rotation vector [rad].
inline Quat quaternion_of(Vec3 rotation) { return quaternion_of(direction(rotation), norm(rotation)); }

}  // namespace pantin
