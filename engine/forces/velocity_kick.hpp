#pragma once
// Half kicks by laws of velocity. Not for use outside world/.
//
// A kick over dt takes the velocities v0 to v = v0 + dt a(w), w = v0 + θ (v - v0), with the positions as they are. θ = ½ is the
// implicit midpoint: of second order, it never lets a law that dissipates gain, and v × B turns v without changing |v|. Where
// dt |∂a/∂v| of what dissipates is above ½, θ = 1, backward Euler, which damps what is too fast for the step (Hairer and
// Wanner, Solving Ordinary Differential Equations II, 1996, IV.3). With one θ ≥ ½ for each thing that moves,
// ΔT = Σ dt f·w - Σ (θ - ½) m |v - v0|², so that what takes energy never gives any.
//
// Newton's iteration on all velocities: the laws are asked at w with their derivatives, then the linear equations are solved,
// those of one thing directly (3 × 3, or 6 × 6 of a body), those of pairs by sweeps that apply equal and opposite impulses.
#include <memory>
#include <string>
#include <vector>

#include "laws/run/answers.hpp"

namespace pantin {

struct World;
struct Forces;
struct Instant;
class TiedKick;
struct TiedWork;

/// What laws of velocity give near to the velocities that they were asked at, and room for a kick that is being solved.
struct VelocityForces {
  SiteSlopes fields, workless;  ///< of laws of single particles; of those of them that do no work by velocity
  /// Pairs of one law.
  struct Listed {
    std::size_t begin, end;
    bool linear;
  };
  std::vector<VelocityPair> pairs;  ///< of interactions and connections
  std::vector<Listed> listed;       ///< of laws, in the order of `pairs`
  AlignedVector<Vec3> at;           ///< (sites) [m/s]
  AlignedVector<Vec3> at_rest;      ///< (sites) [N] what fields give without velocities, but for workless ones
  bool linear = false;              ///< all are, in velocities
  bool known = false;               ///< of the present positions and time
  std::vector<std::shared_ptr<TiedKick>> tied;  ///< of what rows tie, solved and not yet applied

  /// A body, or a tied point. Of what is solved with its articulate v and spin are w.
  struct Carrier {
    Vec3 v0 = zero3(), spin0 = zero3();                               // at the start of the kick
    Vec3 base = zero3(), spun = zero3();                              // with all but what laws of single particles give
    Vec3 v = zero3(), spin = zero3();                                 // at its end
    Vec3 pushed = zero3(), twisted = zero3();                         // [N s], [N m s] impulses of pairs
    Vec3 force = zero3(), torque = zero3();                           // of laws of single particles at w = 0
    Mat3 vv = zero33(), vs = zero33(), sv = zero33(), ss = zero33();  // their derivatives by w
    double inverse_mass = 0.0, theta = 0.5;
    Mat3 mobility = zero33();  // [1/(kg m²)] of turning, world axes
  };
  /// What a pair answers to relative velocities u: its impulse grows by inverse (known + slope u - impulse).
  struct PairAnswer {
    Vec3 known;             // [N s]
    Mat3 slope, inverse;    // [N s²/m], -
    double mobility = 0.0;  // [1/kg]
  };
  std::vector<PairAnswer> answers;      // (pairs)
  std::vector<Carrier> carriers;        // (receivers)
  AlignedVector<Vec3> start, base, v;   // (sites) of free points, as of carriers
  std::vector<double> theta, strength;  // (sites) and then (receivers)
  /// Where a law was asked last in the iteration, and where before that it gave an opposite force.
  struct Asked {
    Vec3 at = zero3(), force = zero3();                    // [m/s], [N]
    Vec3 opposite_at = zero3(), opposite_force = zero3();  // 0: nowhere
  };
  std::vector<Asked> asked_sites, asked_pairs;  // (sites), (pairs)
  AlignedVector<Vec3> told;                     // (sites) [N] of laws of single particles in the solution
  std::vector<Vec3> told_pairs;                 // (pairs) [N]
};

/// Where a kick stands: whether the articulates have the state, and whether a drift with gravity follows it.
struct SideOfDrift {
  bool drifted, before;
};

/// Asks the laws of velocity for their forces and derivatives at Sites::v, and adds the forces to Sites::nonconservative_force.
void find_velocity_slopes(const World& world, Forces& forces, const Instant& instant);
/// Sets the non-conservative forces to those that a kick over dt [s] from the present velocities ends with, with the laws at `time` [s];
/// loose points have had gravity's and pushes' part of it.
void solve_velocity_kick(World& world, Forces& forces, double dt, double time, SideOfDrift side);
/// Changes the momenta of what rows tie as that kick found; forgets it.
TiedWork kick_tied(World& world, Forces& forces);
/// Names of the laws of velocity at work, but for thermostats: "drag or magnet".
std::string velocity_laws(const World& world, Forces& forces);
/// The fastest rate at which laws of velocity damp or turn the velocity of anything where they were asked last [1/s], at most
/// about.
double fastest_change(const World& world, const Forces& forces);
/// What thermostats do in dt [s], in the middle of a drift: O of the splitting BAOAB (Leimkuhler and Matthews 2013), by the
/// implicit midpoint, which keeps Maxwell's distribution for any dt.
void kick_by_thermostats(World& world, double dt);

}  // namespace pantin
