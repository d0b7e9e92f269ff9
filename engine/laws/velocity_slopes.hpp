#pragma once
// How the forces of laws change with velocities: what an implicit kick asks of them.
#include <cstdint>
#include <memory>

#include "base/aligned.hpp"
#include "laws/law.hpp"
#include "laws/sites.hpp"

namespace pantin {

/// The same law whose outputs are followed by their derivatives: of a central law, by the approach; else those of each
/// component of the force by x, then y, then z of the velocity (of b relative to a). A called law stays as it is: its
/// derivatives are differences.
std::shared_ptr<const Law> with_velocity_slopes(const Law& law);
/// Whether the force of a law is linear in velocities; takes what `with_velocity_slopes` made.
bool is_linear_in_velocity(const Law& sloped);
/// Whether what velocities add to the force does no work, as v × B: looked at in samples. False of a called law.
bool is_workless(const Law& law);

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
