#pragma once
// What other engines are compared on as plain data that any of them can be built from, without any code of ours. SI units,
// gravity along -y, y is up, everything at rest at first.
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace pantin::peers {

inline constexpr double gravity = 9.81;  ///< [m/s²]

/// What a solid touches with: nothing; a ball of radius size.x; a box of half edges `size`; a capsule along z of radius
/// size.x, whose line ends at ±size.z.
enum class Form { none, ball, box, capsule };

/// A rigid body; its frame lies at its centre of mass, along its principal axes.
struct SolidDef {
  double mass = 1.0;                                            ///< [kg]
  Eigen::Vector3d moments = {0.02 / 12, 1.01 / 12, 1.01 / 12};  ///< [kg m²] of a box of 1 × 0.1 × 0.1 m and 1 kg
  Eigen::Vector3d at;                                           ///< [m]
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();     ///< body to world
  Form form = Form::none;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< [m] see Form
};

/// A ball joint. In reduced coordinates `b` hangs on `a`, which comes before it, unless the joint closes a loop.
struct BallJoint {
  int a = -1;  ///< -1: the world
  int b = 0;
  Eigen::Vector3d at_a;  ///< [m] in a's frame
  Eigen::Vector3d at_b;  ///< [m] in b's frame
  bool closes_loop = false;
};

/// Everything with normal·x < offset is solid, and does not move.
struct Wall {
  Eigen::Vector3d normal;  ///< of unit length
  double offset;           ///< [m]
};

/// Solids that share a joint do not collide.
struct Mechanism {
  std::string name;
  std::vector<SolidDef> solids;
  std::vector<BallJoint> joints;
  std::vector<Wall> walls = {};
  int measured = 0;         ///< the body whose centre is compared
  double compare_at = 1.0;  ///< [s]
};

struct SolidState {
  Eigen::Vector3d position;  ///< [m] of the centre of mass
  Eigen::Quaterniond turn;   ///< body to world
  Eigen::Vector3d velocity;  ///< [m/s]
  Eigen::Vector3d spin;      ///< [rad/s] in world axes
};

/// The hard cases of `pantin bench articulates`, in the plane z = 0: chain(10), chain(100), heavy(10), heavy(19) and
/// ring(24).
std::vector<Mechanism> mechanisms();

double kinetic_energy(const Mechanism& mechanism, const std::vector<SolidState>& state);    ///< [J]
double potential_energy(const Mechanism& mechanism, const std::vector<SolidState>& state);  ///< [J]
/// [m] largest distance between the two points of a joint.
double largest_separation(const Mechanism& mechanism, const std::vector<SolidState>& state);

}  // namespace pantin::peers
