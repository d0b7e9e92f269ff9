#pragma once
// Quaternions of turns.
#include <cmath>

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
/// The rotation vector [rad] of a turn, the shorter way.
inline Vec3 rotation_vector(const Quat& q) {
  const Vec3 axis = vec(q.x, q.y, q.z) * (q.w < 0.0 ? -1.0 : 1.0);
  return direction(axis) * (2.0 * functions::atan2(norm(axis), std::fabs(q.w)));
}
/// The shorter way from one orientation to another by an even turn, at a part of it (0 … 1).
inline Quat between(const Quat& from, const Quat& to, double part) {
  if (part == 0.0) return from;
  if (part == 1.0) return to;
  return quaternion_of(rotation_vector(to * conjugate(from)) * part) * from;
}

}  // namespace pantin
