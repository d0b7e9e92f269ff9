#pragma once
// Four 3-vectors at a time, one to a lane: no lane idles and nothing is summed across lanes.
#ifdef __AVX__
#include <immintrin.h>
#endif

#include <array>

#include "base/lanes.hpp"

namespace pantin {

/// A number of each of four things.
using Lanes = Vec3;

inline constexpr std::size_t batch_size = 4;

inline Lanes lanes(double s) { return Lanes{s, s, s, s}; }
inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
inline double sum(Lanes a) { return a[0] + a[1] + a[2] + a[3]; }
inline double largest_lane(Lanes a) { return std::fmax(std::fmax(a[0], a[1]), std::fmax(a[2], a[3])); }

/// Whether a comparison holds in any lane.
template <class Mask>
bool any(Mask m) {
#ifdef __AVX__
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0;
#else
  return (m[0] | m[1] | m[2] | m[3]) != 0;
#endif
}

inline Lanes square_root(Lanes a) {
#ifdef __AVX__
  return _mm256_sqrt_pd(a);
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

struct Vec3x4 {
  Lanes x, y, z;
};

inline Vec3x4 operator+(const Vec3x4& a, const Vec3x4& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3x4 operator-(const Vec3x4& a, const Vec3x4& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3x4 operator*(const Vec3x4& a, Lanes s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3x4 operator*(const Vec3x4& a, const Vec3x4& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec3x4 operator*(const Vec3x4& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline void operator+=(Vec3x4& a, const Vec3x4& b) { a = a + b; }
inline void operator-=(Vec3x4& a, const Vec3x4& b) { a = a - b; }
inline Vec3x4 zero3x4() { return {lanes(0.0), lanes(0.0), lanes(0.0)}; }
inline Lanes dot(const Vec3x4& a, const Vec3x4& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes norm2(const Vec3x4& a) { return dot(a, a); }
inline Vec3x4 cross(const Vec3x4& a, const Vec3x4& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The vectors of four things side by side, and apart again.
inline Vec3x4 pack(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes ab_y = __builtin_shufflevector(a, b, 1, 5, 3, 7), cd_y = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab_y, cd_y, 0, 1, 4, 5),
          __builtin_shufflevector(ab, cd, 2, 3, 6, 7)};
}
inline std::array<Vec3, batch_size> unpack(const Vec3x4& v) {
  const Lanes zero = lanes(0.0);
  const Lanes xy = __builtin_shufflevector(v.x, v.y, 0, 4, 2, 6),
              xy_odd = __builtin_shufflevector(v.x, v.y, 1, 5, 3, 7);
  const Lanes z = __builtin_shufflevector(v.z, zero, 0, 4, 2, 6),
              z_odd = __builtin_shufflevector(v.z, zero, 1, 5, 3, 7);
  return {__builtin_shufflevector(xy, z, 0, 1, 4, 5), __builtin_shufflevector(xy_odd, z_odd, 0, 1, 4, 5),
          __builtin_shufflevector(xy, z, 2, 3, 6, 7), __builtin_shufflevector(xy_odd, z_odd, 2, 3, 6, 7)};
}
inline Vec3 lane_of(const Vec3x4& v, std::size_t lane) { return vec(v.x[lane], v.y[lane], v.z[lane]); }
inline void set_lane(Vec3x4& v, std::size_t lane, Vec3 value) {
  v.x[lane] = value[0];
  v.y[lane] = value[1];
  v.z[lane] = value[2];
}

/// By columns.
struct Mat3x4 {
  Vec3x4 column[3];
  Vec3x4& operator[](int i) { return column[i]; }
  const Vec3x4& operator[](int i) const { return column[i]; }
};

inline Vec3x4 operator*(const Mat3x4& a, const Vec3x4& v) { return a[0] * v.x + a[1] * v.y + a[2] * v.z; }
inline Vec3x4 transposed_times(const Mat3x4& a, const Vec3x4& v) { return {dot(a[0], v), dot(a[1], v), dot(a[2], v)}; }
inline Mat3x4 operator*(const Mat3x4& a, Lanes s) { return {{a[0] * s, a[1] * s, a[2] * s}}; }
inline Lanes trace(const Mat3x4& a) { return a[0].x + a[1].y + a[2].z; }
inline Vec3x4 axial(const Mat3x4& b) { return {b[2].y - b[1].z, b[0].z - b[2].x, b[1].x - b[0].y}; }
/// v^
inline Mat3x4 hat(const Vec3x4& v) {
  const Lanes zero = lanes(0.0);
  return {{{zero, v.z, -v.y}, {-v.z, zero, v.x}, {v.y, -v.x, zero}}};
}
/// a v^
inline Mat3x4 times_hat(const Mat3x4& a, const Vec3x4& v) {
  return {{a[1] * v.z - a[2] * v.y, a[2] * v.x - a[0] * v.z, a[0] * v.y - a[1] * v.x}};
}
/// Unit quaternions of four things.
struct Quatx4 {
  Lanes w, x, y, z;
};

inline Quatx4 operator*(const Quatx4& a, const Quatx4& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Mat3x4 matrix(const Quatx4& q) {
  const Lanes xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z,
              wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{{1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (xz - wy)},
           {2.0 * (xy - wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz + wx)},
           {2.0 * (xz + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)}}};
}

/// Inverse by cofactors; no pivoting.
inline Mat3x4 inverse(const Mat3x4& a) {
  const Vec3x4 r0 = cross(a[1], a[2]), r1 = cross(a[2], a[0]), r2 = cross(a[0], a[1]);
  const Lanes s = 1.0 / dot(a[0], r0);
  return {{Vec3x4{r0.x, r1.x, r2.x} * s, Vec3x4{r0.y, r1.y, r2.y} * s, Vec3x4{r0.z, r1.z, r2.z} * s}};
}
/// Σ d_k a_k a_k' of the columns of a
inline Mat3x4 congruent(const Mat3x4& a, const Vec3x4& d) {
  const Vec3x4 u = a[0] * d.x, v = a[1] * d.y, w = a[2] * d.z;
  const Lanes xx = u.x * a[0].x + v.x * a[1].x + w.x * a[2].x, yy = u.y * a[0].y + v.y * a[1].y + w.y * a[2].y,
              zz = u.z * a[0].z + v.z * a[1].z + w.z * a[2].z, yz = u.y * a[0].z + v.y * a[1].z + w.y * a[2].z,
              zx = u.z * a[0].x + v.z * a[1].x + w.z * a[2].x, xy = u.x * a[0].y + v.x * a[1].y + w.x * a[2].y;
  return {{{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}}};
}
inline std::array<Mat3, batch_size> unpack(const Mat3x4& m) {
  const auto x = unpack(m[0]), y = unpack(m[1]), z = unpack(m[2]);
  return {Mat3{{x[0], y[0], z[0]}}, Mat3{{x[1], y[1], z[1]}}, Mat3{{x[2], y[2], z[2]}}, Mat3{{x[3], y[3], z[3]}}};
}

}  // namespace pantin
