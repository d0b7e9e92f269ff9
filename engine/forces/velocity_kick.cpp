#include "forces/velocity_kick.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/check.hpp"
#include "forces/velocity_kick_parts.hpp"

namespace pantin {

namespace {

using kicks::nearly;
using kicks::none;

constexpr int most_iterations = 40;

/// What a law gives at `u` and at rest [N], [m/s], but for what does no work, where its line through the last velocity had
/// `told`.
struct Answer {
  Vec3 force, at_rest, told, u;
  Mat3 slope;
};

/// Newton's slope of a law that saturates, as dry friction does: it has none along u, and the iteration would throw a velocity
/// from one side of rest to the other. So what of the force does not grow with u counts as a drag, as far as the two disagree:
/// the duality of Chan, Golub and Mulet, SIAM J. Sci. Comput. 20, 1999, p. 1964, for any law. `sign` is -1 of pairs.
Mat3 steepened(const Answer& a, double sign) {
  constexpr double hardly = 1e-6;
  const Vec3 by_velocity = a.force - a.at_rest, saturated = by_velocity - a.slope * a.u;
  const double along = dot(saturated, a.u), size2 = norm2(saturated);
  if (!(sign * along < 0.0) || size2 <= hardly * hardly * norm2(by_velocity)) return a.slope;
  const double most = 2.0 * std::fabs(dot(by_velocity, saturated));
  const double differs = std::clamp(dot(a.force - a.told, saturated), 0.0, most);
  return a.slope + outer(saturated, saturated) * (differs / (size2 * along));
}

/// The slope to go on with. Where the force leapt against a change of the velocity, and not about rest, as of what saturates
/// about another velocity, it goes through where the force was opposite (the secant's condition).
Mat3 followed(const Answer& a, VelocityForces::Asked& asked, double sign) {
  constexpr double least_cosine = 0.1, much = 0.5;
  const auto leap_from = [&](Vec3 at, Vec3 force) { return a.force - force - a.slope * (a.u - at); };
  const auto leaps = [&](Vec3 at, Vec3 force) {
    const Vec3 leap = leap_from(at, force), change = a.u - at;
    return norm2(leap) > much * much * norm2(a.force) &&
           sign * dot(leap, change) < -least_cosine * norm(leap) * norm(change);
  };
  if (leaps(asked.at, asked.force)) std::tie(asked.opposite_at, asked.opposite_force) = std::tie(asked.at, asked.force);
  std::tie(asked.at, asked.force) = std::tie(a.u, a.force);
  const Mat3 steep = steepened(a, sign);
  if (norm2(asked.opposite_force) == 0.0 || !leaps(asked.opposite_at, asked.opposite_force)) return steep;
  const Vec3 leap = leap_from(asked.opposite_at, asked.opposite_force);
  const Mat3 through = a.slope + outer(leap, leap) * (1.0 / dot(leap, a.u - asked.opposite_at));
  const bool about_rest = dot(leap, a.u) * dot(leap, asked.opposite_at) < 0.0;
  const double enough = about_rest ? 0.1 : 1.0;
  return sign * dot(leap, through * leap) * enough < sign * dot(leap, steep * leap) ? through : steep;
}

}  // namespace

/// The forces in the solution: of laws of single particles by their derivatives, of pairs as impulses that were applied.
void VelocityKick::tell_forces() {
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

/// Where the law of a site gave another force than was told.
void VelocityKick::follow(std::size_t i) {
  const bool turns = f_.workless && !thermal_;
  const Mat3 turning = turns ? k_.workless.slope[i] : zero33();
  const Vec3 at_rest = thermal_ ? zero3() : k_.at_rest[i], v = f_.sites.v[i],
             workless = turns ? spared_force(f_, k_, i, v) - at_rest : zero3();
  const Answer answer{k_.fields.force[i] - workless, at_rest, k_.told[i] - workless, v, k_.fields.slope[i] - turning};
  k_.fields.slope[i] = turning + followed(answer, k_.asked_sites[i], 1.0);
}

/// Asks the laws at the velocities found, and returns whether they give what was expected of them.
bool VelocityKick::ask_again() {
  const std::size_t n = f_.sites.n;
  tell_forces();
  for (std::size_t i = 0; i < n; i++) f_.sites.v[i] = velocity_of(i);
  ask_velocity_laws(world_, f_, instant_, thermal_, true);
  for (const auto& tied : k_.tied) tied->settled = true;
  double worst = 0.0;
  const auto unsettle = [&](std::size_t site, double missed) {
    worst = std::max(worst, missed);
    const std::uint32_t m = missed > nearly * speed_ ? receiver_at(f_, site) : none;
    if (TiedKick* tied = m == none ? nullptr : tied_to(m)) tied->settled = false;
  };
  for (std::size_t i = 0; i < n; i++) {
    if (!moves(i)) continue;
    const Vec3 force = k_.fields.force[i];
    const double mobility = mobility_of(i);
    const double missed = std::fabs(dt_) * mobility * norm(force - k_.told[i]);
    unsettle(i, missed);
    if (missed > nearly * speed_ || norm2(k_.asked_sites[i].opposite_force) > 0.0) follow(i);
    leave_what_amplifies(k_.fields.slope[i], mobility, 1.0);
  }
  for (const VelocityForces::Listed& law : k_.listed) {
    for (std::size_t k = law.begin; !law.linear && k < law.end; k++) {
      VelocityPair& p = k_.pairs[k];
      const double mobility = mobility_of(p.a) + (p.one_sided ? 0.0 : mobility_of(p.b));
      const double missed = std::fabs(dt_) * mobility * norm(p.force - k_.told_pairs[k]);
      unsettle(p.a, missed);
      unsettle(p.b, missed);
      if (!p.workless && (missed > nearly * speed_ || norm2(k_.asked_pairs[k].opposite_force) > 0.0))
        p.slope = followed({p.force, p.at_rest, k_.told_pairs[k], p.at, p.slope}, k_.asked_pairs[k], -1.0);
      leave_what_amplifies(p.slope, mobility, -1.0);
      find_pair_answer(k);
    }
  }
  return worst <= nearly * speed_;
}

void VelocityKick::solve() {
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
  if (!k_.linear) {
    k_.asked_sites.assign(f_.sites.n, {});
    k_.asked_pairs.assign(k_.pairs.size(), {});
  }
  constexpr int most_turns = 4;  // of rows that let go
  for (int turn = 0; turn < most_turns; turn++) {
    for (const auto& tied : k_.tied) tied->settled = false;
    k_.answers.resize(k_.pairs.size());
    for (std::size_t k = 0; k < k_.pairs.size(); k++) find_pair_answer(k);
    solve_linear();
    bool met = k_.linear;
    for (int iteration = 0; !met && iteration < most_iterations; iteration++) {
      met = ask_again();
      solve_linear();
    }
    tell_forces();
    if (!met) tell_missed();
    if (!finish_tied()) break;
  }
  tell_unsolved();
  if (amplifies_) tell_amplifying();
  if (f_.workless && !thermal_) tell_fast_turns();
}

/// Whether some rows let go.
bool VelocityKick::finish_tied() {
  bool again = false;
  for (const auto& tied : k_.tied) {
    std::vector<Vec3> told;
    for (const TiedKick::NodeSite& s : tied->sites) told.push_back(k_.told[s.site]);
    again = tied->finish(told) || again;
  }
  return again;
}

/// Tells, once, of laws that drive what they act on the more the faster it is.
void VelocityKick::tell_amplifying() {
  tell_once("a force that grows with the velocity gives energy to what it acts on: ", "");
}

/// Tells, once, of laws that act as they were where they were asked, since no velocities go with what they would change by.
void VelocityKick::tell_unsolved() {
  if (std::any_of(k_.tied.begin(), k_.tied.end(), [](const auto& tied) { return tied->without_slopes; }))
    tell_once("velocities could not be solved with a force on what is tied, which acts as it was before: ", "");
}

/// Tells, once, where velocities still changed in the last iteration, and so are not those that the laws make.
void VelocityKick::tell_missed() {
  constexpr double much = 1e-3;  // of the fastest, or of what the laws change in the kick
  double change = 0.0, scale = speed_;
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    if (!moves(i)) continue;
    change = std::fmax(change, norm(velocity_of(i) - f_.sites.v[i]));
    scale = std::fmax(scale, std::fabs(dt_) * mobility_of(i) * norm(k_.told[i]));
  }
  if (change <= much * scale) return;
  tell_once(
      "velocities and what a force makes of them do not agree in a step: ",
      text(", by ", std::round(1e4 * change / scale) / 100.0,
           " % of the fastest; dry friction does with a wider `slip`, other laws with a smoother slope, all with a "
           "shorter scene.step"));
}

/// Tells, once, where a step is too long to follow what turns without losing speed.
void VelocityKick::tell_fast_turns() {
  constexpr double much = 1.0;  // [rad] in a step
  double most = 0.0;
  for (std::size_t i = 0; f_.workless && i < f_.sites.n; i++)
    if (moves(i)) most = std::max(most, 2.0 * std::fabs(dt_) * mobility_of(i) * turning_rate(k_.workless.slope[i]));
  if (most <= much) return;
  tell_once(
      "a force turns velocities farther in a step than it can follow, so that speeds are right and positions are not: ",
      text(", by some ", std::round(most), " rad; scene.accuracy chooses shorter steps"));
}

/// Tells of the laws at work.
void VelocityKick::tell_once(const std::string& what, const std::string& rest) {
  const auto told = [&](const LogLine& line) { return line.text.starts_with(what); };
  if (std::any_of(world_.log.begin(), world_.log.end(), told)) return;
  log_line(world_, "notice", what + velocity_laws(world_, f_) + rest);
}

void VelocityKick::put_forces() {
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    f_.undamped[i] = f_.still[i];
    if (moves(i)) f_.undamped[i] += spared_force(f_, k_, i, velocity_of(i));
    f_.sites.nonconservative_force[i] = f_.still[i] + k_.told[i];
    if (f_.point[i] != none) k_.v[i] -= pressing_on(false, f_.point[i]).force * f_.inverse_mass[i];
  }
  for (std::size_t k = 0; k < k_.pairs.size(); k++) {
    const VelocityPair& p = k_.pairs[k];
    const Vec3 spared = spared_force(p, k_.told_pairs[k]);
    const auto add = [&](std::size_t site, double sign) {
      f_.sites.nonconservative_force[site] += k_.told_pairs[k] * sign;
      f_.undamped[site] += spared * sign;
    };
    add(p.a, 1.0);
    if (!p.one_sided) add(p.b, -1.0);
  }
  collect(world_, f_);
  for (const Attached& a : f_.attached) {
    if (!is_tied(a.receiver)) continue;
    Receiver& m = f_.receivers[a.receiver];
    const Vec3 force = f_.sites.nonconservative_force[a.site] - world_.plane.along(f_.still[a.site]);
    m.solved_force += force;
    m.solved_torque += world_.plane.about(cross(a.r, force));
    m.solved = true;
  }
}

double VelocityKick::apply() {
  double work = 0.0;
  for (std::size_t i = 0; i < f_.sites.n; i++) {
    if (f_.point[i] == none) continue;
    Vec3& v = world_.free_motion[f_.point[i]].v;
    const Vec3 change = k_.told[i] * (f_.inverse_mass[i] * dt_);
    work += dot(k_.told[i], v + change * 0.5) * dt_;
    v += change;
  }
  std::vector<Vec3> force(f_.receivers.size(), zero3()), torque(f_.receivers.size(), zero3());
  for (const Attached& a : f_.attached) {
    force[a.receiver] += k_.told[a.site];
    torque[a.receiver] += world_.plane.about(cross(a.r, k_.told[a.site]));
  }
  for (std::size_t m = 0; m < f_.receivers.size(); m++) {
    if (sleeps(world_, f_.receivers[m]) || is_tied(m)) continue;
    ReceiverMomenta s = momenta_of(world_, f_.receivers[m], side_.drifted);
    const Vec3 v = s.velocity(), spin = s.spin();
    s.add(force[m] * dt_, torque[m] * dt_);
    work += (dot(force[m], v + s.velocity()) + dot(torque[m], spin + s.spin())) * (0.5 * dt_);
  }
  return work;
}

std::string velocity_laws(const World& world, Forces& f) {
  std::string names;
  std::set<std::string> known;
  each_element(f, [&](const ActingElement& a) {
    if (!a.law->velocity_dependent || a.law->thermal) return;
    if (const std::string name = law_at_work(world, a); known.insert(name).second)
      names += (names.empty() ? "" : " or ") + name;
  });
  return names;
}

void solve_velocity_kick(World& world, Forces& f, double dt, double time, SideOfDrift side) {
  const Instant instant = instant_of(world, time, world.instant);
  if (!f.velocity.known) {
    read_velocities(world, f, side.drifted);
    f.still.resize(f.sites.n, zero3());
    f.undamped.resize(f.sites.n, zero3());
    ask_velocity_laws_first(world, f, instant);
  }
  VelocityKick kick(world, f, instant, dt, side);
  kick.solve();
  kick.put_forces();
}

namespace {

TiedWork apply_tied(World& world, Forces& f, VelocityForces& k) {
  TiedWork work;
  std::vector<Vec3> spared;
  for (const auto& tied : k.tied) {
    spared.clear();
    for (const TiedKick::NodeSite& s : tied->sites)
      spared.push_back(&k == &f.velocity ? f.undamped[s.site] - f.still[s.site] : zero3());
    const TiedWork done = tied->apply(spared, world.stage.full);
    work.damper += done.damper;
    work.rest += done.rest;
    work.rows += done.rows;
  }
  k.tied.clear();
  return work;
}

}  // namespace

TiedWork kick_tied(World& world, Forces& f) { return apply_tied(world, f, f.velocity); }

void kick_by_thermostats(World& world, double dt) {
  Forces& f = *world.forces;
  read_positions(world, f, true);
  read_velocities(world, f, true);
  const Instant instant = instant_of(world, world.time, world.instant);
  ask_velocity_laws(world, f, instant, true);
  VelocityKick kick(world, f, instant, dt, {true, false}, true);
  kick.solve();
  post(world, Source::damper, kick.apply());
  post_tied(world, apply_tied(world, f, f.thermostats));
}

}  // namespace pantin
