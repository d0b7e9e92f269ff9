#pragma once
// The hard cases of `pantin bench articulates` as plain data that any engine can be built from, without any code of ours.
// SI units, gravity along -y, y is up, everything at rest at first and in the plane z = 0.
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace pantin::peers {

inline constexpr double gravity = 9.81;  ///< [m/s²]

/// A rigid body; its frame lies at its centre of mass, along its principal axes.
struct SolidDef {
  double mass = 1.0;                                            ///< [kg]
  Eigen::Vector3d moments = {0.02 / 12, 1.01 / 12, 1.01 / 12};  ///< [kg m²] of a box of 1 × 0.1 × 0.1 m and 1 kg
  Eigen::Vector3d at;                                           ///< [m]
  double angle = 0.0;                                           ///< [rad] about z
  Eigen::Quaterniond orientation() const {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
  }
};

/// A ball joint. In reduced coordinates `b` hangs on `a`, unless the joint closes a loop.
struct BallJoint {
  int a = -1;  ///< -1: the world
  int b = 0;
  Eigen::Vector3d at_a;  ///< [m] in a's frame
  Eigen::Vector3d at_b;  ///< [m] in b's frame
  bool closes_loop = false;
};

struct Mechanism {
  std::string name;
  std::vector<SolidDef> solids;
  std::vector<BallJoint> joints;
  int measured = 0;         ///< the body whose centre is compared
  double compare_at = 1.0;  ///< [s]
};

struct SolidState {
  Eigen::Vector3d position;  ///< [m] of the centre of mass
  Eigen::Quaterniond turn;   ///< body to world
  Eigen::Vector3d velocity;  ///< [m/s]
  Eigen::Vector3d spin;      ///< [rad/s] in world axes
};

/// Every case by its name: chain(10), chain(100), heavy(10), heavy(19) and ring(24).
std::vector<Mechanism> mechanisms();

double kinetic_energy(const Mechanism& mechanism, const std::vector<SolidState>& state);    ///< [J]
double potential_energy(const Mechanism& mechanism, const std::vector<SolidState>& state);  ///< [J]
/// [m] largest distance between the two points of a joint.
double largest_separation(const Mechanism& mechanism, const std::vector<SolidState>& state);

}  // namespace pantin::peers
