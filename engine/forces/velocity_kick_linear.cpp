// The linear equations of a kick, near to the velocities that the laws were asked at.
#include <algorithm>
#include <cmath>

#include "articulates/articulate.hpp"
#include "forces/velocity_kick_parts.hpp"

namespace pantin {

namespace {

using kicks::none;
using Carrier = VelocityForces::Carrier;

constexpr int most_sweeps = 200;

bool acts(const VelocityForces& k, std::size_t site) {
  const Mat3& s = k.fields.slope[site];
  return norm2(k.fields.force[site]) + norm2(s[0]) + norm2(s[1]) + norm2(s[2]) > 0.0;
}

}  // namespace

double VelocityKick::mobility_of(std::size_t site) const {
  if (f_.point[site] != none) return f_.inverse_mass[site];
  const std::uint32_t m = receiver_at(f_, site);
  if (m == none) return 0.0;
  const Carrier& c = k_.carriers[m];
  return c.inverse_mass + norm2(arm_of(site)) * largest(vec(c.mobility[0][0], c.mobility[1][1], c.mobility[2][2]));
}

Mat3 VelocityKick::mobility_matrix(std::size_t site) const {
  if (f_.point[site] != none) return identity33() * f_.inverse_mass[site];
  const std::uint32_t m = receiver_at(f_, site);
  if (m == none) return zero33();
  const Carrier& c = k_.carriers[m];
  const Mat3 arm = hat(arm_of(site));
  return identity33() * c.inverse_mass - arm * (c.mobility * arm);
}

double VelocityKick::theta_of(std::size_t site) const {
  const std::uint32_t m = receiver_at(f_, site);
  return m == none ? k_.theta[site] : k_.carriers[m].theta;
}

Vec3 VelocityKick::velocity_of(std::size_t site) const {
  if (f_.point[site] != none) return k_.start[site] + (k_.v[site] - k_.start[site]) * k_.theta[site];
  const std::uint32_t m = receiver_at(f_, site);
  if (m == none) return zero3();
  const Carrier& c = k_.carriers[m];
  return c.v0 + (c.v - c.v0) * c.theta + cross(c.spin0 + (c.spin - c.spin0) * c.theta, arm_of(site));
}

void VelocityKick::push(std::size_t site, Vec3 impulse) {
  if (f_.point[site] != none) {
    k_.base[site] += impulse * f_.inverse_mass[site];
    k_.v[site] += impulse * f_.inverse_mass[site];
    return;
  }
  const std::uint32_t m = receiver_at(f_, site);
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

void VelocityKick::start_carriers() {
  k_.carriers.assign(f_.receivers.size(), {});
  for (std::size_t m = 0; m < f_.receivers.size(); m++) {
    if (sleeps(world_, f_.receivers[m])) continue;
    Carrier& c = k_.carriers[m];
    const ReceiverMomenta s = momenta_of(world_, f_.receivers[m], side_.drifted);
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
    const std::uint32_t m = receiver_at(f_, i);
    if (m == none) continue;
    const Vec3 force = other_force(i);
    Carrier& c = k_.carriers[m];
    c.base += force * (dt_ * c.inverse_mass);
    c.spun += c.mobility * world_.plane.about(cross(arm_of(i), force)) * dt_;
  }
  for (std::size_t m = 0; m < k_.carriers.size(); m++) {
    Carrier& c = k_.carriers[m];
    const BodyLoad pressing = pressing_on(f_.receivers[m].is_body, f_.receivers[m].slot);
    c.base += c.v0 + pressing.force * c.inverse_mass;
    c.spun += c.spin0 + c.mobility * world_.plane.about(pressing.moment);
    if (f_.receivers[m].is_body) {  // its drift has gravity's part of the kick
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

void VelocityKick::start() {
  const std::size_t n = f_.sites.n;
  k_.start.assign(n, zero3());
  k_.base.assign(n, zero3());
  k_.theta.assign(n, 0.5);
  if (!thermal_) pressing_ = pressing_impulses(world_, world_.articulates, world_.contacts, side_.drifted);
  for (std::size_t i = 0; i < n; i++) {
    if (f_.point[i] == none) continue;
    const Vec3 v = world_.free_motion[f_.point[i]].v;
    Vec3 had = thermal_ ? zero3() : world_.settings.gravity * dt_;
    if (world_.pushed && !thermal_) had += world_.points.at_slot(f_.point[i]).force * (f_.inverse_mass[i] * dt_);
    k_.start[i] = v - had;
    k_.base[i] =
        v + other_force(i) * (f_.inverse_mass[i] * dt_) + pressing_on(false, f_.point[i]).force * f_.inverse_mass[i];
    speed_ = std::max({speed_, norm(k_.start[i]), norm(k_.base[i])});
  }
  k_.v = k_.base;
  start_carriers();
}

/// A law that drives what it should damp faster than the step can follow acts as it is at the start.
void VelocityKick::leave_what_amplifies(Mat3& slope, double mobility, double sign) {
  if (!finite(slope)) slope = zero33();
  if (!(sign * trace(slope) > 0.0)) return;
  const double size = std::fabs(dt_) * mobility * working_part(slope);
  amplifies_ = amplifies_ || size > 1e-9;
  if (size > kicks::too_fast) slope = zero33();
}

void VelocityKick::choose_rules() {
  const std::size_t n = f_.sites.n;
  k_.strength.assign(n + k_.carriers.size(), 0.0);
  const auto strength = [&](std::size_t site) -> double& {
    const std::uint32_t m = receiver_at(f_, site);
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
  const auto rule = [&](double size) { return size > kicks::too_fast && !thermal_ ? 1.0 : 0.5; };
  for (std::size_t i = 0; i < n; i++) k_.theta[i] = rule(k_.strength[i]);
  for (std::size_t m = 0; m < k_.carriers.size(); m++) {
    k_.carriers[m].theta = rule(k_.strength[n + m]);
    if (TiedKick* tied = tied_to(m)) tied->theta = std::max(tied->theta, k_.carriers[m].theta);
  }
  for (std::size_t m = 0; m < k_.carriers.size(); m++)
    if (const TiedKick* tied = tied_to(m)) k_.carriers[m].theta = tied->theta;
}

/// Puts what laws of single particles give on the sites of each receiver together.
void VelocityKick::sum_up_carriers() {
  for (Carrier& c : k_.carriers) {
    c.force = c.torque = zero3();
    c.vv = c.vs = c.sv = c.ss = zero33();
  }
  for (const Attached& a : f_.attached) {
    if (is_tied(a.receiver)) continue;
    Carrier& c = k_.carriers[a.receiver];
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
double VelocityKick::pass_points() {
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

double VelocityKick::pass_carriers() {
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

void VelocityKick::find_pair_answer(std::size_t pair) {
  if (inner_[pair]) return;
  const VelocityPair& p = k_.pairs[pair];
  Mat3 give = mobility_matrix(p.a) * theta_of(p.a);
  if (!p.one_sided) give += mobility_matrix(p.b) * theta_of(p.b);
  VelocityForces::PairAnswer& answer = k_.answers[pair];
  answer.known = (p.force - p.slope * p.at) * dt_;
  answer.slope = p.slope * dt_;
  answer.inverse = inverse(identity33() + answer.slope * give);
  answer.mobility = std::max({give[0][0], give[1][1], give[2][2]});
}

/// Applies to each pair in turn the impulse that its law gives at the velocities that come of it; returns about the largest
/// change of a velocity [m/s].
double VelocityKick::pass_pairs(bool forward) {
  double worst2 = 0.0;
  const std::size_t count = k_.pairs.size();
  for (std::size_t k = 0; k < count; k++) {
    const std::size_t at = forward ? k : count - 1 - k;
    if (inner_[at]) continue;
    VelocityPair& p = k_.pairs[at];
    const VelocityForces::PairAnswer& answer = k_.answers[at];
    const Vec3 u = velocity_of(p.b) - velocity_of(p.a);
    const Vec3 more = answer.inverse * (answer.known + answer.slope * u - p.impulse);
    p.impulse += more;
    push(p.a, more);
    if (!p.one_sided) push(p.b, more * -1.0);
    worst2 = std::max(worst2, norm2(more) * (answer.mobility * answer.mobility));
  }
  return std::sqrt(worst2);
}

/// Finds what rows tie, where laws of velocity act on it.
void VelocityKick::find_tied() {
  k_.tied.clear();
  inner_.assign(k_.pairs.size(), 0);
  if (world_.articulates.empty() || !rule_of(world_).conserves) return;
  std::vector<char> asked(world_.articulates.size(), 0);
  const auto note = [&](std::uint32_t site) {
    const std::uint32_t m = receiver_at(f_, site);
    if (m == none || f_.receivers[m].articulate < 0 || k_.carriers[m].inverse_mass == 0.0) return;
    asked[static_cast<std::size_t>(f_.receivers[m].articulate)] = 1;
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
    k_.tied.push_back(std::make_shared<TiedKick>(world_, k_, i, dt_, side_));
    tied_of_[i] = k_.tied.back().get();
  }
  std::vector<std::size_t> index_of(f_.sites.n, 0);
  for (const Attached& a : f_.attached) {
    TiedKick* tied = tied_to(a.receiver);
    if (tied == nullptr) continue;
    index_of[a.site] = tied->sites.size();
    tied->sites.push_back({a.site, f_.receivers[a.receiver].node, a.r});
  }
  const auto tied_at = [&](std::uint32_t site) {
    const std::uint32_t m = receiver_at(f_, site);
    return m == none ? nullptr : tied_to(m);
  };
  for (std::size_t k = 0; k < k_.pairs.size(); k++) {
    const VelocityPair& p = k_.pairs[k];
    TiedKick *tied = tied_at(p.a), *other = tied_at(p.b);
    if (tied != other) {
      if (tied != nullptr) tied->crossed = true;
      if (other != nullptr) other->crossed = true;
    } else if (tied != nullptr) {
      tied->pairs.push_back({k, index_of[p.a], index_of[p.b]});
      inner_[k] = 1;
    }
  }
}

void VelocityKick::start_tied() {
  std::vector<Vec3> forces;
  for (const auto& tied : k_.tied) {
    forces.clear();
    for (const TiedKick::NodeSite& s : tied->sites) forces.push_back(other_force(s.site));
    tied->start(forces, thermal_, pressing_);
    tied->choose_rule(kicks::too_fast);
    for (std::size_t m = 0; m < f_.receivers.size(); m++)
      if (tied_to(m) == tied.get()) k_.carriers[m].theta = tied->theta;
  }
}

/// All that are not settled, or those that pairs push from elsewhere.
void VelocityKick::solve_tied(bool all) {
  for (const auto& tied : k_.tied) {
    if (!tied->crossed && (!all || tied->settled)) continue;
    tied->clear_pushes();
    for (std::size_t m = 0; m < f_.receivers.size(); m++)
      if (tied->crossed && tied_to(m) == tied.get())
        tied->push(f_.receivers[m].node, k_.carriers[m].pushed, k_.carriers[m].twisted);
    tied->solve();
  }
  for (std::size_t m = 0; m < f_.receivers.size(); m++) {
    const TiedKick* tied = tied_to(m);
    if (tied == nullptr) continue;
    Carrier& c = k_.carriers[m];
    c.v0 = c.v = tied->mean_velocity(f_.receivers[m].node);
    c.spin0 = c.spin = tied->mean_spin(f_.receivers[m].node);
  }
}

void VelocityKick::solve_linear() {
  sum_up_carriers();
  const bool sweeps = std::find(inner_.begin(), inner_.end(), 0) != inner_.end();
  for (int sweep = 0; sweep < most_sweeps; sweep++) {
    pass_points();
    pass_carriers();
    solve_tied(sweep == 0);
    if (!sweeps || !(pass_pairs(sweep % 2 == 0) > kicks::exactly * speed_)) break;
  }
  if (!sweeps) return;
  pass_points();
  pass_carriers();
  solve_tied(false);
}

}  // namespace pantin
