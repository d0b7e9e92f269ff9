#pragma once
// A kick by laws of velocity on what rows tie. Not for use outside world/.
//
// It changes velocities only as the rows allow at the present positions: v = v0 + o + dt P M⁻¹ f(w), w = v0 + θ (v - v0), with
// P M⁻¹ what impulses make of velocities through all rows, and o the same of other forces, which the drift applies. So no
// law of velocity moves what the rows would have to turn back, and its work is f·w dt: v × B keeps the energy, drag takes.
//
// With f = c + S w, (1 - dt θ P M⁻¹ S) w = v0 + θ (o + dt P M⁻¹ c) is solved by Galerkin's condition on the Krylov space of
// the right side (full orthogonalisation, in the scalar product of the kinetic energy; Saad, Iterative Methods for Sparse
// Linear Systems, 2003, 6.4): w is in that space, so that the balance of energy holds at any size of it.
#include <cstdint>
#include <memory>
#include <vector>

#include "articulates/articulate.hpp"
#include "articulates/solve/motions.hpp"
#include "contacts/pressing.hpp"
#include "forces/forces.hpp"

namespace pantin {

/// What a kick gave [J].
struct TiedWork {
  double damper = 0.0, rest = 0.0;  ///< by laws of velocity: those that take, and those that do no work by it
  ImpulseWork rows;                 ///< by what is prescribed
};

class TiedKick {
 public:
  /// A site that laws act on.
  struct NodeSite {
    std::uint32_t site;
    std::size_t node;
    Vec3 r;  ///< [m] arm in the world
  };
  /// A pair with both ends here, by its place in VelocityForces::pairs and those of its sites.
  struct Pair {
    std::size_t pair, a, b;
  };

  /// Of an articulate that has the state where `drifted`, else what the model has.
  TiedKick(World& world, VelocityForces& laws, std::size_t articulate, double dt, SideOfDrift side);
  ~TiedKick();
  TiedKick(const TiedKick&) = delete;
  TiedKick& operator=(const TiedKick&) = delete;

  std::vector<NodeSite> sites;
  std::vector<Pair> pairs;
  bool crossed = false;  ///< some pairs have one end elsewhere
  bool without_slopes =
      false;             ///< with what laws change by it has no solution in numbers: they act as where they were asked
  bool settled = false;  ///< the laws give what was expected of them at w
  double theta = 0.5;

  std::size_t articulate() const { return index_; }
  /// Takes the forces that do not depend on velocities: those on its sites [N], and unless the laws act `alone` what the
  /// drift applies, gravity, pushes and twists.
  void start(const std::vector<Vec3>& forces, bool alone, const std::vector<BodyLoad>& pressing);
  /// Finds what goes by `theta` and the rows that hold anew.
  void find_known();
  /// Where what acts on single sites is too fast for a step of dt: `too_fast` is the bound of dt |∂a/∂v|. What is light is
  /// damped more slowly where it moves what is heavy. And where laws overdamp all that pulls without forbidding, these
  /// pulls count as the coming drift has them; else their swings are damped as they are at the ends of steps.
  void choose_rule(double too_fast);
  /// Forgets impulses of other pairs; takes one on a node [N s], [N m s].
  void clear_pushes() { pushes_.assign(a_->batches.size(), {}); }
  void push(std::size_t node, Vec3 impulse, Vec3 angular);
  /// Solves for w, with what laws give near to the velocities that they were asked at.
  void solve();
  /// w of a node [m/s], [rad/s].
  Vec3 mean_velocity(std::size_t node) const { return lane_of(w_[node / batch_size].v, node % batch_size); }
  Vec3 mean_spin(std::size_t node) const { return lane_of(w_[node / batch_size].w, node % batch_size); }
  /// Finds what it changes, and what rows bear of the forces [N] on its sites; whether one that would have to pull lets go, so
  /// that all is to be solved again.
  bool finish(const std::vector<Vec3>& told);
  /// Changes the momenta, and tells the rows what they bear of a full sub-step of `full` [s]. Of what the laws do, forces
  /// `spared` [N] on its sites do not damp.
  TiedWork apply(const std::vector<Vec3>& spared, double full);

 private:
  /// A row that pulls without forbidding: its force on a is force + slope (v_a - v_b).
  struct Soft {
    NodeSite a, b;
    bool two;  // else b is a position
    std::size_t row;
    Vec3 force;        // [N]
    Mat3 slope;        // [N s/m]
    double stiffness;  // [N/m]
  };

  bool can_drive();
  bool solve_with_slopes();
  void hold(Condition& condition, bool held);
  bool let_go();
  Motions allowed(const Motions& impulses);
  /// Forces that velocities make: of the laws; and of them and soft rows.
  Motions forces_of_laws(const Motions& by) const;
  Motions forces_of_laws_and_soft_rows(const Motions& by) const;
  Motions told_impulses(const std::vector<Vec3>& told) const;
  Motions given_back() const;
  double add_given_back();
  double scale_to(double given);
  void change_momenta(Node& node, Vec3 v, Vec3 p, Vec3 L);
  void add(Motions& to, const NodeSite& site, Vec3 impulse) const;
  Vec3 velocity_at(const Motions& of, const NodeSite& site) const;
  void find_soft_rows();
  double fastest_damping();      // [1/s] by laws, through all rows, from below
  double fastest_swing() const;  // [1/s] at most, of soft rows
  void add(Motions& to, const Soft& soft, Vec3 impulse) const;
  void add_forces_of_soft_rows(Motions& to, const Motions& by, double times) const;

  World& world_;
  VelocityForces& laws_;
  std::size_t index_;
  double dt_;
  SideOfDrift side_;
  Articulate* a_;                     // works on the momenta of its batches
  std::unique_ptr<Articulate> copy_;  // of one that an edit changed: its velocities are made consistent in the drift
  bool ties_ = true;                  // its rows forbid velocities
  std::vector<char> held_;            // (conditions)
  std::vector<Vec3> wanted_;          // (conditions) [m/s]
  std::vector<Soft> soft_;
  std::vector<Vec3> forces_on_sites_, told_;
  std::vector<BodyLoad> pressing_;  // (nodes) [N s], [N m s] of contacts in the kick; none: nothing presses
  bool alone_ = false, at_rest_ = false;
  double epsilon_ = 0.0;                                // compliance of the rows that they need
  Motions pushes_, v0_, driven_, others_, w_, change_;  // driven_: the least motion that what is prescribed asks for
  Motions back_;             // gives back the angular momentum that rows made, whose points are apart
  double asked_ = 0.0;       // [J^½] size of the last motion that was made allowed, before it was
  std::vector<Vec3> borne_;  // (rows) [N s]
};

void post_tied(World& world, const TiedWork& work);

}  // namespace pantin
