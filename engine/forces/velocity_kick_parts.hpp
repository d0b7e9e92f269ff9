#pragma once
// A half kick by laws of velocity while it is being solved, see velocity_kick.hpp.
#include <cstdint>
#include <vector>

#include "contacts/pressing.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"
#include "forces/receiver_momenta.hpp"
#include "forces/tied_kick.hpp"

namespace pantin {

namespace kicks {
constexpr std::uint32_t none = Forces::none;
constexpr double too_fast = 0.5;  ///< dt |∂a/∂v| beyond which a kick is backward Euler's
constexpr double nearly = 1e-9;   ///< of the speeds: what a solution may miss
constexpr double exactly = 1e-13;
}  // namespace kicks

inline bool finite(const Mat3& m) { return finite(m[0]) && finite(m[1]) && finite(m[2]); }
/// How fast the antisymmetric part of a slope turns velocities of a unit mass [1/s].
double turning_rate(const Mat3& slope);
/// Size of the symmetric part, which is what does work [N s/m].
double working_part(const Mat3& slope);
/// The receiver that a site is on, or Forces::none.
inline std::uint32_t receiver_at(const Forces& f, std::size_t site) {
  const std::uint32_t attached = f.attached_of[site];
  return attached == Forces::none ? Forces::none : f.attached[attached].receiver;
}
/// Fills in what laws of velocity give at Sites::v: thermostats, or the others. Where they are asked `again` in a kick, pairs
/// of laws that are linear stay as they are.
void ask_velocity_laws(const World& world, Forces& forces, const Instant& instant, bool thermal, bool again = false);
/// The same of all but thermostats at new positions or another time: also fills in what they give at rest.
void ask_velocity_laws_first(const World& world, Forces& forces, const Instant& instant);

/// Of what laws of velocity give a site that moves with v [m/s], or a pair of all that they give it: what they also give at
/// rest, and what does no work by the velocity [N].
Vec3 spared_force(const Forces& forces, const VelocityForces& laws, std::size_t site, Vec3 v);
Vec3 spared_force(const VelocityPair& pair, Vec3 all);

/// Solves a kick for all that laws of velocity act on.
class VelocityKick {
 public:
  VelocityKick(World& world, Forces& f, const Instant& instant, double dt, SideOfDrift side, bool thermal = false)
      : world_(world),
        f_(f),
        k_(thermal ? f.thermostats : f.velocity),
        instant_(instant),
        side_(side),
        thermal_(thermal),
        dt_(dt) {
    start();
  }

  void solve();
  /// Sets the non-conservative forces to those of the solution.
  void put_forces();
  /// Changes velocities and momenta as the solution does; returns the work [J].
  double apply();

 private:
  void start();
  void start_carriers();
  void choose_rules();
  void find_tied();
  void start_tied();
  void solve_tied(bool all);
  bool finish_tied();
  void follow(std::size_t site);
  void leave_what_amplifies(Mat3& slope, double mobility, double sign);
  void sum_up_carriers();
  double pass_points();
  double pass_carriers();
  void find_pair_answer(std::size_t pair);
  double pass_pairs(bool forward);
  void solve_linear();
  void tell_forces();
  void tell_amplifying();
  void tell_fast_turns();
  void tell_missed();
  void tell_unsolved();
  void tell_once(const std::string& what, const std::string& rest);
  bool ask_again();

  /// Of laws that do not depend on velocities [N].
  Vec3 other_force(std::size_t site) const {
    return thermal_ ? zero3() : f_.sites.force[site] + world_.plane.along(f_.still[site]);
  }
  /// What the receiver is solved with; null where it is solved alone.
  TiedKick* tied_to(std::size_t receiver) const {
    const std::int32_t i = f_.receivers[receiver].articulate;
    return i < 0 || tied_of_.empty() ? nullptr : tied_of_[static_cast<std::size_t>(i)];
  }
  /// By gravity, in the kick [m/s].
  Vec3 gravity_change() const { return thermal_ ? zero3() : world_.plane.along(world_.settings.gravity) * dt_; }
  bool moves(std::size_t i) const {
    return f_.point[i] != kicks::none || (receiver_at(f_, i) != kicks::none && !left_out(receiver_at(f_, i)));
  }
  /// Whether no law of velocity acts on what the receiver is tied to.
  bool left_out(std::size_t receiver) const { return is_tied(receiver) && !tied_to(receiver); }
  bool is_tied(std::size_t receiver) const {
    return f_.receivers[receiver].articulate >= 0 && rule_of(world_).conserves;
  }
  /// Of contacts in the kick; none where nothing presses.
  BodyLoad pressing_on(bool is_body, std::uint32_t slot) const {
    return pressing_.empty() ? BodyLoad{} : pressing_[is_body ? slot : world_.bodies.slots() + slot];
  }
  double mobility_of(std::size_t site) const;
  Mat3 mobility_matrix(std::size_t site) const;
  double theta_of(std::size_t site) const;
  Vec3 arm_of(std::size_t site) const { return f_.attached[f_.attached_of[site]].r; }
  /// w of a site, [m/s].
  Vec3 velocity_of(std::size_t site) const;
  void push(std::size_t site, Vec3 impulse);

  World& world_;
  Forces& f_;
  VelocityForces& k_;
  Instant instant_;
  SideOfDrift side_;
  std::vector<TiedKick*> tied_of_;  // (articulates), null where no law of velocity acts; empty: nowhere
  std::vector<BodyLoad> pressing_;  // [N s], [N m s] by slots of bodies, then of points; empty: nothing presses
  std::vector<char> inner_;         // (pairs) whether both ends are solved together
  bool amplifies_ = false;
  bool thermal_;             // of thermostats alone, in the middle of a drift
  double dt_, speed_ = 0.0;  // [s], [m/s] fastest
};

}  // namespace pantin
