#pragma once
// Sites of one articulate on which laws of velocity are too fast for the step: what one does to the others, through all that
// is hinged together. Not for use outside world/.
#include <cstdint>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

struct World;
struct Forces;

struct TiedSites {
  static constexpr std::size_t most = 32;  ///< more act each as if its body were free

  std::vector<std::uint32_t> sites;
  std::vector<Vec3> velocity;  ///< (sites) [m/s] that the rows allow, at the start of the kick
  std::vector<Vec3> falling;   ///< (sites) [m/s²] by gravity, as far as the rows allow it
  std::vector<Mat3> response;  ///< (sites × sites) [1/kg] velocity of the first by an impulse on the second
  std::vector<Vec3> force;     ///< (sites) [N] of the laws, in the solution
  std::vector<Vec3> moved;     ///< (sites) [m/s] velocities there

  /// `sites` are of movers of one articulate, and the articulates have the state.
  TiedSites(World& world, const Forces& forces, std::vector<std::uint32_t> sites);
  /// The same at the start of the next step, where velocities are allowed as they are.
  void read_velocities(World& world, const Forces& forces, bool drifted);
  /// Solves force = asked + slope (velocity - at), with the velocities at the end of a kick of dt [s] that `others`, which
  /// do not depend on them, these forces, and gravity for `fall` [s] make. All (sites).
  void solve(const std::vector<Vec3>& asked, const std::vector<Mat3>& slope, const std::vector<Vec3>& at,
             const std::vector<Vec3>& others, double dt, double fall);
};

}  // namespace pantin
