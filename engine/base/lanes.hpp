#pragma once
// Vectors and matrices of the hot loops: one padded 4-lane vector of doubles per 3-vector. Only + - * / and sqrt, and
// sums in a written order, so every compiler, lane width and optimisation level gives the same bits.
#include <cmath>
#include <limits>

namespace pantin {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A 3-vector in four lanes. Make one with `vec(x, y, z)`; lanes 0, 1, 2 are x, y, z and lane 3 stays 0.
using Vec3 = double __attribute__((vector_size(32)));

inline Vec3 vec(double x, double y, double z) { return Vec3{x, y, z, 0.0}; }
inline Vec3 zero3() { return Vec3{0.0, 0.0, 0.0, 0.0}; }
inline double dot(Vec3 a, Vec3 b) {
  const Vec3 c = a * b;
  return c[0] + c[1] + c[2];
}
inline Vec3 rotate_lanes(Vec3 a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); }
inline Vec3 cross(Vec3 a, Vec3 b) { return rotate_lanes(a * rotate_lanes(b) - rotate_lanes(a) * b); }
inline double norm2(Vec3 a) { return dot(a, a); }
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }
/// a / |a|, or `fallback` where a is 0.
inline Vec3 direction(Vec3 a, Vec3 fallback = vec(1, 0, 0)) {
  const double n = norm(a);
  return n > 0.0 ? a / n : fallback;
}
inline double largest(Vec3 a) { return std::fmax(std::fabs(a[0]), std::fmax(std::fabs(a[1]), std::fabs(a[2]))); }
inline bool finite(Vec3 a) { return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]); }
inline bool same(Vec3 a, Vec3 b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

/// A 3 x 3 matrix by columns.
struct Mat3 {
  Vec3 column[3];
  Vec3& operator[](int i) { return column[i]; }
  const Vec3& operator[](int i) const { return column[i]; }
};

inline Mat3 zero33() { return {{zero3(), zero3(), zero3()}}; }
inline Mat3 diagonal(Vec3 d) { return {{vec(d[0], 0, 0), vec(0, d[1], 0), vec(0, 0, d[2])}}; }
inline Mat3 identity33() { return diagonal(vec(1, 1, 1)); }
inline Vec3 operator*(const Mat3& a, Vec3 v) { return a[0] * v[0] + a[1] * v[1] + a[2] * v[2]; }
inline Mat3 operator*(const Mat3& a, const Mat3& b) { return {{a * b[0], a * b[1], a * b[2]}}; }
inline Mat3 operator*(const Mat3& a, double s) { return {{a[0] * s, a[1] * s, a[2] * s}}; }
inline Mat3 operator+(const Mat3& a, const Mat3& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Mat3 operator-(const Mat3& a, const Mat3& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
inline void operator+=(Mat3& a, const Mat3& b) {
  for (int i = 0; i < 3; i++) a[i] += b[i];
}
inline void operator-=(Mat3& a, const Mat3& b) {
  for (int i = 0; i < 3; i++) a[i] -= b[i];
}
inline Mat3 transpose(const Mat3& a) {
  return {{vec(a[0][0], a[1][0], a[2][0]), vec(a[0][1], a[1][1], a[2][1]), vec(a[0][2], a[1][2], a[2][2])}};
}
/// transpose(a) v
inline Vec3 transposed_times(const Mat3& a, Vec3 v) { return vec(dot(a[0], v), dot(a[1], v), dot(a[2], v)); }
/// a transpose(b)
inline Mat3 times_transposed(const Mat3& a, const Mat3& b) {
  Mat3 c;
  for (int j = 0; j < 3; j++) c[j] = a[0] * b[0][j] + a[1] * b[1][j] + a[2] * b[2][j];
  return c;
}
/// Σ d_k a_k a_k' of the columns of a
inline Mat3 congruent(const Mat3& a, Vec3 d) { return times_transposed({{a[0] * d[0], a[1] * d[1], a[2] * d[2]}}, a); }
/// a b' of two vectors
inline Mat3 outer(Vec3 a, Vec3 b) { return {{a * b[0], a * b[1], a * b[2]}}; }
/// The matrix v^ of the cross product: hat(v) w = v x w.
inline Mat3 hat(Vec3 v) { return {{vec(0, v[2], -v[1]), vec(-v[2], 0, v[0]), vec(v[1], -v[0], 0)}}; }
inline double trace(const Mat3& a) { return a[0][0] + a[1][1] + a[2][2]; }
/// axial(u v') = u x v.
inline Vec3 axial(const Mat3& b) { return vec(b[2][1] - b[1][2], b[0][2] - b[2][0], b[1][0] - b[0][1]); }
/// Inverse by cofactors; no pivoting.
inline Mat3 inverse(const Mat3& a) {
  const Vec3 r0 = cross(a[1], a[2]), r1 = cross(a[2], a[0]), r2 = cross(a[0], a[1]);
  const double s = 1.0 / dot(a[0], r0);
  return transpose({{r0 * s, r1 * s, r2 * s}});
}

/// A unit quaternion w + xi + yj + zk; turns body axes to world axes.
struct Quat {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

inline Quat operator*(const Quat& a, const Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline bool same(const Quat& a, const Quat& b) { return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z; }
inline Quat conjugate(const Quat& q) { return {q.w, -q.x, -q.y, -q.z}; }
inline Quat normalised(const Quat& q) {
  const double s = 1.0 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}

inline Mat3 matrix(const Quat& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z,
               wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{vec(1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)), vec(2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)),
           vec(2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy))}};
}
/// The quaternion of a proper rotation matrix (Shepperd 1978).
inline Quat quaternion(const Mat3& m) {
  const double t = trace(m);
  if (t > 0.0) return normalised({1.0 + t, m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]});
  if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2])
    return normalised({m[1][2] - m[2][1], 1.0 + 2.0 * m[0][0] - t, m[0][1] + m[1][0], m[2][0] + m[0][2]});
  if (m[1][1] >= m[2][2])
    return normalised({m[2][0] - m[0][2], m[0][1] + m[1][0], 1.0 + 2.0 * m[1][1] - t, m[1][2] + m[2][1]});
  return normalised({m[0][1] - m[1][0], m[2][0] + m[0][2], m[1][2] + m[2][1], 1.0 + 2.0 * m[2][2] - t});
}
inline Vec3 rotate(const Quat& q, Vec3 v) {
  const Vec3 u = vec(q.x, q.y, q.z), t = cross(u, v) * 2.0;
  return v + t * q.w + cross(u, t);
}

}  // namespace pantin
