#include "world/velocity_kick.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/articulate.hpp"
#include "base/check.hpp"
#include "world/forces_parts.hpp"
#include "world/integrator.hpp"
#include "world/mover_momenta.hpp"
#include "world/tied_kick.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t none = Forces::none;
constexpr double too_fast = 0.5;  ///< dt |∂a/∂v| beyond which a kick is backward Euler's
constexpr int most_iterations = 40, restart = 3, trusted_iterations = 16, most_sweeps = 200;
constexpr double nearly = 1e-9, exactly = 1e-15;  // of the speeds

using Carrier = VelocityForces::Carrier;
using Side = SideOfDrift;

/// Size of the symmetric part, which is what does work [N s/m].
double working_part(const Mat3& m) {
  const Mat3 sum = m + transpose(m);
  return 0.5 * std::sqrt(norm2(sum[0]) + norm2(sum[1]) + norm2(sum[2]));
}

bool acts(const VelocityForces& k, std::size_t site) {
  const Mat3& s = k.fields.slope[site];
  return norm2(k.fields.force[site]) + norm2(s[0]) + norm2(s[1]) + norm2(s[2]) > 0.0;
}

bool finite(const Mat3& m) { return pantin::finite(m[0]) && pantin::finite(m[1]) && pantin::finite(m[2]); }

/// Where the velocity of a site is kept.
std::uint32_t mover_at(const Forces& f, std::size_t site) {
  const std::uint32_t attached = f.attached_of[site];
  return attached == none ? none : f.attached[attached].mover;
}

/// Fills in what laws of velocity give at Sites::v: thermostats, or the others.
void ask(const World& world, Forces& f, const Instant& instant, bool thermal) {
  VelocityForces& k = thermal ? f.thermostats : f.velocity;
  const std::size_t n = f.sites.n;
  const auto asked = [&](const Law& law) { return law.moving && law.thermal == thermal; };
  k.fields.clear(n);
  if (f.workless) k.workless.clear(n);
  k.pairs.clear();
  k.linear = k.known = true;
  for (ActingField& a : f.fields) {
    if (!asked(*a.law)) continue;
    const auto parameters = present_parameters(world, *a.law, world.fields[a.id].parameters);
    k.linear &= a.fields.add_slopes(f.sites, box_of(world), instant, parameters, *world.workers, k.fields);
    if (a.law->workless) a.fields.add_slopes(f.sites, box_of(world), instant, parameters, *world.workers, k.workless);
  }
  for (ActingInteraction& a : f.interactions) {
    if (!asked(*a.law)) continue;
    const auto parameters = present_parameters(world, *a.law, world.interactions[a.id].parameters);
    k.linear &= a.pairs.list_slopes(f.sites, a.rows, instant, parameters, k.pairs);
  }
  for (ActingConnections& a : f.connections)
    if (asked(*a.law) && !a.solved) k.linear &= a.bonds.list_slopes(f.sites, box_of(world), instant, {}, k.pairs);
  k.at.assign(n, zero3());
  std::copy_n(f.sites.v.begin(), n, k.at.begin());
  const Plane& plane = world.plane;
  if (!plane.flat()) return;
  const auto flatten = [&](Vec3& force, Mat3& slope) {
    force = plane.along(force);
    for (int c = 0; c < 3; c++) slope[c] = plane.along(slope[c]);
  };
  for (std::size_t i = 0; i < n; i++) flatten(k.fields.force[i], k.fields.slope[i]);
  for (std::size_t i = 0; f.workless && i < n; i++) flatten(k.workless.force[i], k.workless.slope[i]);
  for (VelocityPair& p : k.pairs) flatten(p.force, p.slope);
}

/// A kick while it is being solved.
class Kick {
 public:
  Kick(World& world, Forces& f, const Instant& instant, double dt, Side side, bool thermal = false)
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
  /// Sets the open forces to those of the solution.
  void put_forces();
  /// Changes velocities and momenta as the solution does; returns the work [J].
  double apply();

 private:
  void start();
  void start_carriers();
  void choose_rules();
  void find_tied();
  void start_tied();
  void solve_tied();
  bool finish_tied();
  void leave_what_amplifies(Mat3& slope, double mobility, double sign);
  void sum_up_carriers();
  double pass_points();
  double pass_carriers();
  double pass_pairs(bool forward);
  void solve_linear();
  void tell_forces();
  void tell_amplifying();
  bool ask_again(int iteration);

  /// Of laws that do not depend on velocities [N].
  Vec3 other_force(std::size_t site) const {
    return thermal_ ? zero3() : f_.sites.force[site] + world_.plane.along(f_.still[site]);
  }
  /// What the mover is solved with; null where it is solved alone.
  TiedKick* tied_to(std::size_t mover) const {
    const std::int32_t i = f_.movers[mover].articulate;
    return i < 0 || tied_of_.empty() ? nullptr : tied_of_[static_cast<std::size_t>(i)];
  }
  /// By gravity, in the kick [m/s].
  Vec3 gravity() const { return thermal_ ? zero3() : world_.plane.along(world_.settings.gravity); }
  Vec3 gravity_change() const { return gravity() * dt_; }
  bool moves(std::size_t i) const {
    return f_.point[i] != none || (mover_at(f_, i) != none && !left_out(mover_at(f_, i)));
  }
  /// Whether no law of velocity acts on what the mover is tied to.
  bool left_out(std::size_t mover) const { return is_tied(mover) && !tied_to(mover); }
  bool is_tied(std::size_t mover) const { return f_.movers[mover].articulate >= 0 && rule_of(world_).conserves; }
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
  Side side_;
  std::vector<TiedKick*> tied_of_;  // (articulates), null where no law of velocity acts; empty: nowhere
  std::vector<char> inner_;         // (pairs) whether both ends are solved together
  bool amplifies_ = false;
  std::vector<char> from_rest_;  // (sites) whether their law is asked at rest next
  bool thermal_;                 // of thermostats alone, in the middle of a drift
  double dt_, speed_ = 0.0;      // [s], [m/s] fastest
};

double Kick::mobility_of(std::size_t site) const {
  if (f_.point[site] != none) return f_.inverse_mass[site];
  const std::uint32_t m = mover_at(f_, site);
  if (m == none) return 0.0;
  const Carrier& c = k_.carriers[m];
  return c.inverse_mass + norm2(arm_of(site)) * largest(vec(c.mobility[0][0], c.mobility[1][1], c.mobility[2][2]));
}

Mat3 Kick::mobility_matrix(std::size_t site) const {
  if (f_.point[site] != none) return identity33() * f_.inverse_mass[site];
  const std::uint32_t m = mover_at(f_, site);
  if (m == none) return zero33();
  const Carrier& c = k_.carriers[m];
  const Mat3 arm = hat(arm_of(site));
  return identity33() * c.inverse_mass - arm * (c.mobility * arm);
}

double Kick::theta_of(std::size_t site) const {
  const std::uint32_t m = mover_at(f_, site);
  return m == none ? k_.theta[site] : k_.carriers[m].theta;
}

Vec3 Kick::velocity_of(std::size_t site) const {
  if (f_.point[site] != none) return k_.start[site] + (k_.v[site] - k_.start[site]) * k_.theta[site];
  const std::uint32_t m = mover_at(f_, site);
  if (m == none) return zero3();
  const Carrier& c = k_.carriers[m];
  return c.v0 + (c.v - c.v0) * c.theta + cross(c.spin0 + (c.spin - c.spin0) * c.theta, arm_of(site));
}

void Kick::push(std::size_t site, Vec3 impulse) {
  if (f_.point[site] != none) {
    k_.base[site] += impulse * f_.inverse_mass[site];
    k_.v[site] += impulse * f_.inverse_mass[site];
    return;
  }
  const std::uint32_t m = mover_at(f_, site);
  if (m == none) return;
  Carrier& c = k_.carriers[m];
  const Vec3 turned = c.mobility * world_.plane.about(cross(arm_of(site), impulse));
  c.base += impulse * c.inverse_mass;
  c.v += impulse * c.inverse_mass;
  c.spun += turned;
  c.spin += turned;
  c.pushed += impulse;
  c.twisted += world_.plane.about(cross(arm_of(site), impulse));
}

void Kick::start_carriers() {
  k_.carriers.assign(f_.movers.size(), {});
  for (std::size_t m = 0; m < f_.movers.size(); m++) {
    if (sleeps(world_, f_.movers[m])) continue;
    Carrier& c = k_.carriers[m];
    const MoverMomenta s = momenta_of(world_, f_.movers[m], side_.drifted);
    c.v0 = s.velocity();
    c.spin0 = s.spin();
    c.inverse_mass = s.inverse_mass;
    if (!s.P) continue;
    const Mat3 R = matrix(s.q);
    Vec3 O = s.inverse_inertia;
    if (s.line) O[0] = 0.0;
    c.mobility = times_transposed(R * diagonal(O), R);
    if (world_.plane.flat()) {
      const int n = world_.plane.normal;
      Mat3 about = zero33();
      about[n][n] = c.mobility[n][n];
      c.mobility = about;
    }
  }
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    const std::uint32_t m = mover_at(f_, i);
    if (m == none) continue;
    const Vec3 force = other_force(i);
    Carrier& c = k_.carriers[m];
    c.base += force * (dt_ * c.inverse_mass);
    c.spun += c.mobility * world_.plane.about(cross(arm_of(i), force)) * dt_;
  }
  for (std::size_t m = 0; m < k_.carriers.size(); m++) {
    Carrier& c = k_.carriers[m];
    c.base += c.v0;
    c.spun += c.spin0;
    if (f_.movers[m].is_body) {  // its drift has gravity's part of the kick
      if (side_.before)
        c.base += gravity_change();
      else
        c.v0 -= gravity_change();
    }
    c.v = c.base;
    c.spin = c.spun;
    speed_ = std::max({speed_, norm(c.v0), norm(c.v)});
  }
}

void Kick::start() {
  const std::size_t n = f_.sites.n;
  k_.start.assign(n, zero3());
  k_.base.assign(n, zero3());
  k_.theta.assign(n, 0.5);
  for (std::size_t i = 0; i < n; i++) {
    if (f_.point[i] == none) continue;
    const Vec3 v = world_.free_motion[f_.point[i]].v;
    Vec3 had = thermal_ ? zero3() : world_.settings.gravity * dt_;
    if (world_.pushed && !thermal_) had += world_.points.at_slot(f_.point[i]).force * (f_.inverse_mass[i] * dt_);
    k_.start[i] = v - had;
    k_.base[i] = v + other_force(i) * (f_.inverse_mass[i] * dt_);
    speed_ = std::max({speed_, norm(k_.start[i]), norm(k_.base[i])});
  }
  k_.v = k_.base;
  start_carriers();
}

/// A law that drives what it should damp faster than the step can follow acts as it is at the start.
void Kick::leave_what_amplifies(Mat3& slope, double mobility, double sign) {
  const bool amplifies = sign * trace(slope) > 0.0;
  const double size = std::fabs(dt_) * mobility * working_part(slope);
  amplifies_ = amplifies_ || (amplifies && size > 1e-9);
  if (!finite(slope) || (amplifies && size > too_fast)) slope = zero33();
}

void Kick::choose_rules() {
  const std::size_t n = f_.sites.n;
  k_.strength.assign(n + k_.carriers.size(), 0.0);
  const auto strength = [&](std::size_t site) -> double& {
    const std::uint32_t m = mover_at(f_, site);
    return k_.strength[m == none ? site : n + m];
  };
  for (std::size_t i = 0; i < n; i++)
    if (moves(i)) strength(i) += std::fabs(dt_) * mobility_of(i) * working_part(k_.fields.slope[i]);
  for (const VelocityPair& p : k_.pairs) {
    const double size = 2.0 * std::fabs(dt_) * working_part(p.slope);
    strength(p.a) += size * mobility_of(p.a);
    if (!p.one_sided) strength(p.b) += size * mobility_of(p.b);
  }
  // A thermostat's midpoint keeps the distribution of velocities exactly, however fast it is.
  const auto rule = [&](double size) { return size > too_fast && !thermal_ ? 1.0 : 0.5; };
  for (std::size_t i = 0; i < n; i++) k_.theta[i] = rule(k_.strength[i]);
  for (std::size_t m = 0; m < k_.carriers.size(); m++) {
    k_.carriers[m].theta = rule(k_.strength[n + m]);
    if (TiedKick* tied = tied_to(m)) tied->theta = std::max(tied->theta, k_.carriers[m].theta);
  }
  for (std::size_t m = 0; m < k_.carriers.size(); m++)
    if (const TiedKick* tied = tied_to(m)) k_.carriers[m].theta = tied->theta;
}

/// Puts what laws of single particles give on the sites of each mover together.
void Kick::sum_up_carriers() {
  for (Carrier& c : k_.carriers) {
    c.force = c.torque = zero3();
    c.vv = c.vs = c.sv = c.ss = zero33();
  }
  for (const Attached& a : f_.attached) {
    if (is_tied(a.mover)) continue;
    Carrier& c = k_.carriers[a.mover];
    const Mat3 &slope = k_.fields.slope[a.site], arm = hat(a.r);
    const Vec3 force = k_.fields.force[a.site] - slope * k_.at[a.site];
    c.force += force;
    c.torque += cross(a.r, force);
    const Mat3 turning = slope * arm, turned = arm * slope;
    c.vv += slope;
    c.vs -= turning;
    c.sv += turned;
    c.ss -= arm * turning;
  }
}

/// Solves the points alone, each with what pairs give it now; returns the largest change of a velocity [m/s].
double Kick::pass_points() {
  double worst = 0.0;
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    if (f_.point[i] == none) continue;
    const double m = dt_ * f_.inverse_mass[i], theta = k_.theta[i];
    const Mat3& slope = k_.fields.slope[i];
    const Vec3 known = k_.start[i] * (1.0 - theta) - k_.at[i];
    const Vec3 rest = k_.base[i] + (k_.fields.force[i] + slope * known) * m;
    const Vec3 v = inverse(identity33() - slope * (m * theta)) * rest;
    worst = std::max(worst, norm(v - k_.v[i]));
    k_.v[i] = v;
  }
  return worst;
}

double Kick::pass_carriers() {
  double worst = 0.0;
  for (std::size_t k = 0; k < k_.carriers.size(); k++) {
    Carrier& c = k_.carriers[k];
    if (c.inverse_mass == 0.0 || is_tied(k)) continue;
    const double m = dt_ * c.inverse_mass, theta = c.theta;
    const Vec3 v0 = c.v0 * (1.0 - theta), s0 = c.spin0 * (1.0 - theta);
    const Vec3 rest_v = c.base + (c.force + c.vv * v0 + c.vs * s0) * m;
    const Vec3 rest_s = c.spun + c.mobility * (c.torque + c.sv * v0 + c.ss * s0) * dt_;
    const Mat3 a = inverse(identity33() - c.vv * (m * theta)), b = c.vs * (m * theta);
    const Mat3 turned = c.mobility * c.sv * (dt_ * theta);
    const Mat3 d = identity33() - c.mobility * c.ss * (dt_ * theta) - turned * (a * b);
    const Vec3 spin = inverse(d) * (rest_s + turned * (a * rest_v)), v = a * (rest_v + b * spin);
    worst = std::max(worst, norm(v - c.v));
    c.v = v;
    c.spin = spin;
  }
  return worst;
}

/// Applies to each pair in turn the impulse that its law gives at the velocities that come of it.
double Kick::pass_pairs(bool forward) {
  double worst = 0.0;
  const std::size_t count = k_.pairs.size();
  for (std::size_t k = 0; k < count; k++) {
    const std::size_t at = forward ? k : count - 1 - k;
    if (inner_[at]) continue;
    VelocityPair& p = k_.pairs[at];
    Mat3 give = mobility_matrix(p.a) * theta_of(p.a);
    if (!p.one_sided) give += mobility_matrix(p.b) * theta_of(p.b);
    const Vec3 u = velocity_of(p.b) - velocity_of(p.a);
    const Vec3 missing = (p.force + p.slope * (u - p.at)) * dt_ - p.impulse;
    const Vec3 more = inverse(identity33() + p.slope * give * dt_) * missing;
    p.impulse += more;
    push(p.a, more);
    if (!p.one_sided) push(p.b, more * -1.0);
    worst = std::max(worst, norm(give * more));
  }
  return worst;
}

/// Finds what rows tie, where laws of velocity act on it.
void Kick::find_tied() {
  k_.tied.clear();
  inner_.assign(k_.pairs.size(), 0);
  if (world_.articulates.empty() || !rule_of(world_).conserves) return;
  std::vector<char> asked(world_.articulates.size(), 0);
  const auto note = [&](std::uint32_t site) {
    const std::uint32_t m = mover_at(f_, site);
    if (m == none || f_.movers[m].articulate < 0 || k_.carriers[m].inverse_mass == 0.0) return;
    asked[static_cast<std::size_t>(f_.movers[m].articulate)] = 1;
  };
  for (const Attached& a : f_.attached)
    if (acts(k_, a.site)) note(a.site);
  for (const VelocityPair& p : k_.pairs) {
    note(p.a);
    if (!p.one_sided) note(p.b);
  }
  tied_of_.assign(asked.size(), nullptr);
  for (std::size_t i = 0; i < asked.size(); i++) {
    if (!asked[i]) continue;
    k_.tied.push_back(std::make_shared<TiedKick>(world_, f_, k_, i, dt_, side_));
    tied_of_[i] = k_.tied.back().get();
  }
  std::vector<std::size_t> seat(f_.sites.n, 0);
  for (const Attached& a : f_.attached) {
    TiedKick* tied = tied_to(a.mover);
    if (tied == nullptr) continue;
    seat[a.site] = tied->seats.size();
    tied->seats.push_back({a.site, f_.movers[a.mover].node, a.r});
  }
  const auto tied_at = [&](std::uint32_t site) {
    const std::uint32_t m = mover_at(f_, site);
    return m == none ? nullptr : tied_to(m);
  };
  for (std::size_t k = 0; k < k_.pairs.size(); k++) {
    const VelocityPair& p = k_.pairs[k];
    TiedKick *tied = tied_at(p.a), *other = tied_at(p.b);
    if (tied != other) {
      if (tied != nullptr) tied->crossed = true;
      if (other != nullptr) other->crossed = true;
    } else if (tied != nullptr) {
      tied->pairs.push_back({k, seat[p.a], seat[p.b]});
      inner_[k] = 1;
    }
  }
}

void Kick::start_tied() {
  std::vector<Vec3> forces;
  for (const auto& tied : k_.tied) {
    forces.clear();
    for (const TiedKick::Seat& s : tied->seats) forces.push_back(other_force(s.site));
    tied->start(forces, gravity());
    // What is light is damped more slowly where it moves what is heavy.
    if (tied->theta == 0.5 || tied->crossed || std::fabs(dt_) * tied->fastest_damping() > too_fast) continue;
    tied->theta = 0.5;
    tied->find_known();
    for (std::size_t m = 0; m < f_.movers.size(); m++)
      if (tied_to(m) == tied.get()) k_.carriers[m].theta = 0.5;
  }
}

void Kick::solve_tied() {
  for (const auto& tied : k_.tied) {
    tied->clear_pushes();
    for (std::size_t m = 0; m < f_.movers.size(); m++)
      if (tied->crossed && tied_to(m) == tied.get())
        tied->push(f_.movers[m].node, k_.carriers[m].pushed, k_.carriers[m].twisted);
    tied->solve();
  }
  for (std::size_t m = 0; m < f_.movers.size(); m++) {
    const TiedKick* tied = tied_to(m);
    if (tied == nullptr) continue;
    Carrier& c = k_.carriers[m];
    c.v0 = c.v = tied->mean_velocity(f_.movers[m].node);
    c.spin0 = c.spin = tied->mean_spin(f_.movers[m].node);
  }
}

void Kick::solve_linear() {
  sum_up_carriers();
  const bool sweeps = std::find(inner_.begin(), inner_.end(), 0) != inner_.end();
  for (int sweep = 0; sweep < most_sweeps; sweep++) {
    pass_points();
    pass_carriers();
    solve_tied();
    if (!sweeps || !(pass_pairs(sweep % 2 == 0) > exactly * speed_)) break;
  }
  if (!sweeps) return;
  pass_points();
  pass_carriers();
  solve_tied();
}

/// The forces in the solution: of laws of single particles by their derivatives, of pairs as impulses that were applied.
void Kick::tell_forces() {
  const std::size_t n = f_.sites.n;
  k_.told_pairs.resize(k_.pairs.size());
  for (std::size_t i = 0; i < n; i++)
    if (moves(i)) k_.told[i] = k_.fields.force[i] + k_.fields.slope[i] * (velocity_of(i) - k_.at[i]);
  for (std::size_t k = 0; k < k_.pairs.size(); k++) {
    VelocityPair& p = k_.pairs[k];
    if (inner_[k]) p.impulse = (p.force + p.slope * (velocity_of(p.b) - velocity_of(p.a) - p.at)) * dt_;
    k_.told_pairs[k] = p.impulse / dt_;
  }
}

/// A law that Newton's iteration does not get on with is taken for a drag along its force, which gives that force at `u`.
Mat3 chord(Vec3 force, Vec3 u, double sign) {
  const double power = sign * dot(force, u);
  return power < 0.0 ? outer(force, force) * (sign / power) : zero33();
}

/// Asks the laws at the velocities found, and returns whether they give what was expected of them.
bool Kick::ask_again(int iteration) {
  const std::size_t n = f_.sites.n;
  tell_forces();
  from_rest_.resize(n, 0);
  for (std::size_t i = 0; i < n; i++) f_.sites.v[i] = from_rest_[i] ? zero3() : velocity_of(i);
  const std::vector<VelocityPair> before = std::move(k_.pairs);
  ask(world_, f_, instant_, thermal_);
  assume(k_.pairs.size() == before.size());
  k_.missed.resize(n + before.size(), infinity);
  double worst = 0.0;
  /// Whether the iteration has stopped getting nearer.
  const auto is_stuck = [&](std::size_t at, double missed) {
    const double last = std::exchange(k_.missed[at], missed);
    worst = std::max(worst, missed);
    return iteration >= trusted_iterations && missed > 0.25 * last && missed > nearly * speed_;
  };
  for (std::size_t i = 0; i < n; i++) {
    if (!moves(i)) continue;
    const Vec3 force = k_.fields.force[i];
    const double mobility = mobility_of(i);
    const double missed = from_rest_[i] ? infinity : std::fabs(dt_) * mobility * norm(force - k_.told[i]);
    // Dry friction stops what slides: its slope there does not tell, that of rest leads to the solution from below.
    from_rest_[i] = iteration == restart && missed > nearly * speed_;
    if (is_stuck(i, missed)) k_.fields.slope[i] = chord(force, f_.sites.v[i], 1.0);
    leave_what_amplifies(k_.fields.slope[i], mobility, 1.0);
  }
  for (std::size_t k = 0; k < before.size(); k++) {
    VelocityPair& p = k_.pairs[k];
    p.impulse = before[k].impulse;
    const double mobility = mobility_of(p.a) + (p.one_sided ? 0.0 : mobility_of(p.b));
    if (is_stuck(n + k, std::fabs(dt_) * mobility * norm(p.force - k_.told_pairs[k])))
      p.slope = chord(p.force, p.at, -1.0);
    leave_what_amplifies(p.slope, mobility, -1.0);
  }
  return worst <= nearly * speed_;
}

void Kick::solve() {
  for (std::size_t i = 0; i < f_.sites.n; i++)
    if (moves(i)) leave_what_amplifies(k_.fields.slope[i], mobility_of(i), 1.0);
  for (VelocityPair& p : k_.pairs) {
    leave_what_amplifies(p.slope, mobility_of(p.a) + (p.one_sided ? 0.0 : mobility_of(p.b)), -1.0);
    p.impulse = zero3();
  }
  find_tied();
  choose_rules();
  k_.told.assign(f_.sites.n, zero3());
  start_tied();
  constexpr int most_turns = 4;  // of rows that let go
  for (int turn = 0; turn < most_turns; turn++) {
    solve_linear();
    k_.missed.clear();
    for (int iteration = 0; !k_.linear && iteration < most_iterations; iteration++) {
      const bool done = ask_again(iteration);
      solve_linear();
      if (done) break;
    }
    tell_forces();
    if (!finish_tied()) break;
  }
  if (amplifies_) tell_amplifying();
}

/// Whether some rows let go.
bool Kick::finish_tied() {
  bool again = false;
  for (const auto& tied : k_.tied) {
    std::vector<Vec3> told;
    for (const TiedKick::Seat& s : tied->seats) told.push_back(k_.told[s.site]);
    again = tied->finish(told) || again;
  }
  return again;
}

/// Tells, once, of laws that drive what they act on the more the faster it is.
void Kick::tell_amplifying() {
  constexpr const char* what = "a force that grows with the velocity drives what it acts on ever faster: ";
  const auto told = [&](const LogLine& line) { return line.text.starts_with(what); };
  if (std::any_of(world_.log.begin(), world_.log.end(), told)) return;
  std::string names;
  each_law(world_, f_, [&](const std::string&, const Law& law, auto& acting) {
    if (law.moving && !law.thermal) names += (names.empty() ? "" : " or ") + law_at_work(world_, acting);
  });
  log_line(world_, "notice", what + names);
}

void Kick::put_forces() {
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    f_.undamped[i] = f_.still[i];
    if (f_.workless && moves(i))
      f_.undamped[i] += k_.workless.force[i] + k_.workless.slope[i] * (velocity_of(i) - k_.at[i]);
    f_.sites.open_force[i] = f_.still[i] + k_.told[i];
  }
  for (std::size_t k = 0; k < k_.pairs.size(); k++) {
    const VelocityPair& p = k_.pairs[k];
    const auto add = [&](std::size_t site, Vec3 force) {
      f_.sites.open_force[site] += force;
      if (p.workless) f_.undamped[site] += force;
    };
    add(p.a, k_.told_pairs[k]);
    if (!p.one_sided) add(p.b, k_.told_pairs[k] * -1.0);
  }
  collect(world_, f_);
  for (const Attached& a : f_.attached) {
    if (!is_tied(a.mover)) continue;
    Mover& m = f_.movers[a.mover];
    const Vec3 force = f_.sites.open_force[a.site] - world_.plane.along(f_.still[a.site]);
    m.solved_force += force;
    m.solved_torque += world_.plane.about(cross(a.r, force));
    m.solved = true;
  }
}

double Kick::apply() {
  double work = 0.0;
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    if (f_.point[i] == none) continue;
    Vec3& v = world_.free_motion[f_.point[i]].v;
    const Vec3 change = k_.told[i] * (f_.inverse_mass[i] * dt_);
    work += dot(k_.told[i], v + change * 0.5) * dt_;
    v += change;
  }
  std::vector<Vec3> force(f_.movers.size(), zero3()), torque(f_.movers.size(), zero3());
  for (const Attached& a : f_.attached) {
    force[a.mover] += k_.told[a.site];
    torque[a.mover] += world_.plane.about(cross(a.r, k_.told[a.site]));
  }
  for (std::size_t m = 0; m < f_.movers.size(); m++) {
    if (sleeps(world_, f_.movers[m]) || is_tied(m)) continue;
    MoverMomenta s = momenta_of(world_, f_.movers[m], side_.drifted);
    const Vec3 v = s.velocity(), spin = s.spin();
    s.add(force[m] * dt_, torque[m] * dt_);
    work += (dot(force[m], v + s.velocity()) + dot(torque[m], spin + s.spin())) * (0.5 * dt_);
  }
  return work;
}

}  // namespace

void find_velocity_slopes(const World& world, Forces& f, const Instant& instant) {
  ask(world, f, instant, false);
  const VelocityForces& k = f.velocity;
  f.undamped = f.still;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    f.sites.open_force[i] += k.fields.force[i];
    if (f.workless) f.undamped[i] += k.workless.force[i];
  }
  for (const VelocityPair& p : k.pairs) {
    const auto add = [&](std::size_t site, Vec3 force) {
      f.sites.open_force[site] += force;
      if (p.workless) f.undamped[site] += force;
    };
    add(p.a, p.force);
    if (!p.one_sided) add(p.b, p.force * -1.0);
  }
}

void solve_velocity_kick(World& world, Forces& f, double dt, double time, Side side) {
  const Instant instant = instant_of(world, time, world.instant);
  if (!f.velocity.known) {
    read_velocities(world, f, side.drifted);
    f.still.resize(f.sites.n, zero3());
    f.undamped.resize(f.sites.n, zero3());
    ask(world, f, instant, false);
  }
  Kick kick(world, f, instant, dt, side);
  kick.solve();
  kick.put_forces();
}

namespace {

TiedWork apply_tied(World& world, Forces& f, VelocityForces& k) {
  TiedWork work;
  std::vector<Vec3> spared;
  for (const auto& tied : k.tied) {
    spared.clear();
    for (const TiedKick::Seat& s : tied->seats)
      spared.push_back(&k == &f.velocity && f.workless ? f.undamped[s.site] - f.still[s.site] : zero3());
    const TiedWork done = tied->apply(spared, world.part.full);
    work.damper += done.damper;
    work.rest += done.rest;
    work.rows += done.rows;
  }
  k.tied.clear();
  return work;
}

}  // namespace

TiedWork kick_tied(World& world, Forces& f) { return apply_tied(world, f, f.velocity); }

double fastest_damping(const World& world, const Forces& f) {
  double fastest = 0.0;
  for (std::size_t i = 0; f.velocity.known && i < f.sites.n; i++) {
    double mobility = f.inverse_mass[i];
    if (const std::uint32_t m = mover_at(f, i); m != none && f.movers[m].is_body) {
      const Motion& motion = world.motion[f.movers[m].slot];
      mobility = 1.0 / motion.mass + norm2(f.attached[f.attached_of[i]].r) * largest(inverse_inertia(motion));
    }
    fastest = std::max(fastest, mobility * working_part(f.velocity.fields.slope[i]));
  }
  return fastest;
}

void kick_by_thermostats(World& world, double dt) {
  Forces& f = *world.forces;
  read_places(world, f, true);
  read_velocities(world, f, true);
  const Instant instant = instant_of(world, world.time, world.instant);
  ask(world, f, instant, true);
  Kick kick(world, f, instant, dt, {true, false}, true);
  kick.solve();
  post(world, Source::damper, kick.apply());
  post_tied(world, apply_tied(world, f, f.thermostats));
}

}  // namespace pantin
