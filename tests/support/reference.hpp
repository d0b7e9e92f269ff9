#pragma once
// Motions worked out another way: equations of motion in the fewest coordinates, without any code of the engine,
// integrated by extrapolation (Gragg 1965, Bulirsch and Stoer 1966) to near round-off.
#include <Eigen/Core>
#include <functional>
#include <vector>

namespace pantin::reference {

using State = Eigen::VectorXd;

/// Integrates dy/dt = rate(y) over `time` [s] in equal pieces, each of order 16.
State integrate(const std::function<State(const State&)>& rate, State y, double time, int pieces);

/// One rigid link of a plane chain.
struct Link {
  double length = 1.0;           ///< [m] from its head to the head of the next
  double centre = 0.5;           ///< [m] from its head to its centre of mass
  double mass = 1.0;             ///< [kg]
  double inertia = 1.01 / 12.0;  ///< [kg m²] about its centre
};

/// Links hanging on each other from the origin, in the plane of x and y, gravity along -y.
struct PlaneChain {
  std::vector<Link> links;
  double gravity = 9.81;  ///< [m/s²]
  State start;            ///< angles from the x axis [rad], then their rates [rad/s]
  bool closed = false;    ///< the tail of the last link is held at the origin
};

PlaneChain plane_chain(int links);
/// With a solid sphere of radius 0.5 m and `ratio` [kg] jointed at its surface as the last link.
PlaneChain heavy_plane_chain(int links, double ratio);
/// A closed regular polygon of unit rods, its topmost corner held at the origin; links follow each other from there.
PlaneChain plane_ring(int links);
State rate(const PlaneChain& chain, const State& y);
State advance(const PlaneChain& chain, double time, int pieces);
/// Place of a link's centre of mass, [m].
Eigen::Vector2d centre(const PlaneChain& chain, const State& y, int link);
double energy(const PlaneChain& chain, const State& y);  ///< [J]

/// Angles from the downward vertical [rad], then rates, of the double pendulum with unit masses and lengths, from rest
/// at 90° each.
State double_pendulum(double time, int pieces);

/// Angular velocity in the body's frame [rad/s] of a free top with moments (1, 2, 3), from (0.01, 1, 0.01).
Eigen::Vector3d top(double time, int pieces);

/// Orientation (w, x, y, z), then angular velocity in the body's frame [rad/s], of a body with principal moments [kg m²]
/// under a constant torque of the world [N m], from no rotation.
State free_body(Eigen::Vector3d moments, Eigen::Vector3d spin, Eigen::Vector3d torque, double time, int pieces);

}  // namespace pantin::reference
