#pragma once
// What an implicit kick asks of the laws that depend on velocities, and is answered.
#include <cstdint>

#include "base/aligned.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Forces on single sites, near to the velocities [m/s] that they were asked at: force + slope (v - at).
struct SiteSlopes {
  AlignedVector<Vec3> force;  ///< (sites) [N]
  AlignedVector<Mat3> slope;  ///< (sites) [N s/m]

  void clear(std::size_t n) {
    force.assign(n, zero3());
    slope.assign(n, zero33());
  }
};

/// The force of a law on site a, and the opposite one on b, near to the velocity of b relative to a that it was asked at:
/// force + slope (u - at).
struct VelocityPair {
  std::uint32_t a = 0, b = 0;
  bool one_sided = false;  ///< b feels nothing
  bool workless = false;
  Vec3 force = zero3(), at = zero3();  ///< [N], [m/s]
  Mat3 slope = zero33();               ///< [N s/m]
  Vec3 at_rest = zero3();              ///< [N] without relative velocity; none where workless
  Vec3 impulse = zero3();              ///< [N s] while a kick is being solved
};

/// Differences that the derivatives of called laws are taken over [m/s]: relative to the fastest site.
double velocity_difference(const Sites& sites);

}  // namespace pantin
