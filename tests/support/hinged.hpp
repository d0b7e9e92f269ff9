#pragma once
// Trees of ball hinges in all coordinates of their bodies, without any code of the engine: forces of hinges from one sparse
// system of all of them, integrated by extrapolation.
#include <Eigen/Core>
#include <vector>

#include "support/reference.hpp"

namespace pantin::reference {

struct HingedBody {
  double mass = 1.0;  ///< [kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::
      Zero();  ///< [kg m²] about its centre at the start, in world axes; 0: a point, which does not turn
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), velocity = at, spin = at;  ///< [m], [m/s], [rad/s] at the start
};

/// Ties body a to body b, or to the world (-1), where `at` is at the start [m].
struct BallHinge {
  int a = 0, b = -1;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

struct Hinged {
  std::vector<HingedBody> bodies;
  std::vector<BallHinge> hinges;
  Eigen::Vector3d gravity = {0, -9.81, 0};  ///< [m/s²]
};

/// Positions, velocities, orientations against the start (w, x, y, z) and spins, 13 numbers of each body.
State start(const Hinged& hinged);
State rate(const Hinged& hinged, const State& y);
State advance(const Hinged& hinged, double time, int pieces);
/// [m] of a body's centre.
Eigen::Vector3d centre(const State& y, int body);
double energy(const Hinged& hinged, const State& y);  ///< [J]

}  // namespace pantin::reference
