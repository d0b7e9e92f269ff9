#include "forces/kick_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "articulates/articulate.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/sub_steps.hpp"
#include "constraints/row_rule.hpp"
#include "forces/encounters.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"
#include "forces/step_sizes.hpp"

namespace pantin {

namespace {

constexpr std::array<double, 3> unknown = {infinity, infinity, infinity};
constexpr double once_around = 6.3, half_around = 3.1;  // [rad]

/// A fraction 0 … 1 that never comes back in the rhythm of the steps: multiples of the golden ratio.
double fraction_of(std::uint64_t number) {
  const double x = static_cast<double>((number + 1) % (std::uint64_t{1} << 40)) * 0.6180339887498949;
  return x - std::floor(x);
}

/// Calls `use` with forces that are without noise.
template <class Use>
void without_noise(World& world, Forces& f, Use use) {
  const auto add = [&](double sign) {
    if (f.noise.empty()) return;
    for (std::size_t i = 0; i < f.sites.n; i++) f.sites.nonconservative_force[i] += f.noise[i] * sign;
    collect(world, f);
  };
  add(-1.0);
  use();
  add(1.0);
}

double mass_of(const World& world, const Receiver& m) {
  return m.is_body ? world.motion[m.slot].mass : world.points.at_slot(m.slot).mass;
}

Vec3 acceleration(const World& world, const Forces& f, std::size_t site) {
  if (f.attached_of[site] != Forces::none) {
    const Receiver& m = f.receivers[f.attached[f.attached_of[site]].receiver];
    return (m.force + m.nonconservative_force) / mass_of(world, m);
  }
  const Vec3 force =
      f.nonconservative ? f.sites.force[site] + f.sites.nonconservative_force[site] : f.sites.force[site];
  return force * f.inverse_mass[site];
}

Vec3 position(const Forces& f, std::size_t site) { return f.sites.x[site] + f.image[site]; }

/// Whether what a site is on is tied by rows: it has a length of its own.
const Articulate* articulate_of(const World& world, const Forces& f, std::size_t site) {
  if (f.attached_of[site] == Forces::none) return nullptr;
  const Receiver& m = f.receivers[f.attached[f.attached_of[site]].receiver];
  return m.articulate < 0 ? nullptr : world.articulates[static_cast<std::size_t>(m.articulate)].get();
}

/// How far a body reaches from its centre, as its inertia tells [m].
double reach_of(const World& world, const Receiver& m) {
  if (!m.is_body) return 0.0;
  const Motion& motion = world.motion[m.slot];
  return std::sqrt(largest(motion.inertia) / motion.mass);
}

/// Looked at in all stages of a step, not once a step.
bool is_young(const Swing& swing) { return swing.n < 4.0; }
void begin_notes(World& world, Forces& f) {
  KickNotes& n = f.notes;
  const std::size_t slots = world.particles.slots();
  const bool grown = n.swing.size() < slots;
  n.acceleration.resize(slots, zero3());
  n.position.resize(slots, zero3());
  n.within.resize(slots, zero3());
  n.jerk.resize(slots, unknown);
  n.untold.resize(slots, 0.0);
  n.swing.resize(slots);
  if (world.stage.index != 0) return;
  bool young = false;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    const std::uint32_t slot = f.sites.particle[i];
    if (slot == Forces::none) continue;
    if (n.swing[slot].serial != f.sites.serial[i]) {
      n.swing[slot] = {.serial = f.sites.serial[i]};
      n.jerk[slot] = unknown;
      n.untold[slot] = 0.0;
    }
    young = young || is_young(n.swing[slot]);
  }
  n.kept_jerk = n.jerk;
  n.kept_untold = n.untold;
  n.kept_swing.clear();
  if (young) n.kept_swing = n.swing;
  n.told_in_step = n.jumps_in_step = 0.0;
  n.told_late = false;
  if (!f.interactions.empty() && (grown || world.steps % 16 == 0 || f.settled_in == world.steps + 1))
    find_partners(world, f);
}

}  // namespace

void note_kicks(World& world) {
  if (!world.forces) return;
  Forces& f = *world.forces;
  begin_notes(world, f);
  without_noise(world, f, [&] {
    for (std::size_t i = 0; i < f.sites.n; i++) {
      const std::uint32_t slot = f.sites.particle[i];
      if (slot == Forces::none) continue;
      f.notes.acceleration[slot] = acceleration(world, f, i);
      f.notes.position[slot] = position(f, i);
    }
    for (Receiver& m : f.receivers) m.noted_torque = m.torque + m.nonconservative_torque;
  });
}

void forget_rejected(World& world) {
  if (!world.forces || world.forces->notes.swing.empty()) return;
  KickNotes& n = world.forces->notes;
  n.jerk = n.kept_jerk;
  n.untold = n.kept_untold;
  if (!n.kept_swing.empty()) n.swing = n.kept_swing;
  if (!world.forces->interactions.empty()) find_partners(world, *world.forces);
}

void note_swings(World& world) {
  if (!world.forces) return;
  const Forces& f = *world.forces;
  KickNotes& n = world.forces->notes;
  const double time = time_within(world, fraction_of(world.steps));
  for (std::size_t i = 0; i < f.sites.n; i++) {
    const std::uint32_t slot = f.sites.particle[i];
    if (slot == Forces::none || slot >= n.swing.size() || n.swing[slot].serial == 0) continue;
    Swing& swing = n.swing[slot];
    if (std::isfinite(n.jerk[slot][0])) swing.jerk = std::max(swing.jerk, n.jerk[slot][0]);
    swing.acceleration = std::max(swing.acceleration, norm(acceleration(world, f, i)));
    if (n.kept_swing.empty() || !is_young(n.kept_swing[slot])) swing.add(n.within[slot], time, 1.0);
  }
}

namespace {

/// The error of a stage of a step.
class Judge {
 public:
  Judge(World& world, Forces& f)
      : world_(world), f_(f), n_(f.notes), box_(box_of(world)), h_(std::fabs(world.stage.h)) {}

  void judge_all() {
    find_changes();
    if (f_.timed) add_changes_of_time();
    n_.near.assign(f_.sites.n, infinity);
    for (const ActingConnections& c : f_.connections)
      if (!c.solved) judge_ties(c.bond_list);
    if (!f_.interactions.empty()) judge_partners();
    for (std::size_t i = 0; i < f_.sites.n; i++)
      if (f_.sites.particle[i] != Forces::none) judge_site(i);
  }

  void judge(const Encounter& met) {
    const Vec3 change = vec(met.acceleration, 0, 0), moved = vec(0.5 * met.displacement, 0, 0);
    const double swing = swing_by(stiffness_along(change, moved), change, moved, h_);
    see(met.site, met.acceleration, std::max(met.distance, swing), true);
  }

  double fastest() const { return std::sqrt(fastest2_); }
  double nearest() const {
    double least = infinity;
    for (double near : n_.near) least = std::min(least, near);
    return least;
  }
  double worst() const { return worst_; }

 private:
  void find_changes() {
    n_.change.assign(f_.sites.n, zero3());
    n_.moved.assign(f_.sites.n, zero3());
    n_.turning.assign(f_.sites.n, 0.0);
    const bool looked_at = is_looked_at();
    for (std::size_t i = 0; i < f_.sites.n; i++) {
      const std::uint32_t slot = f_.sites.particle[i];
      if (slot == Forces::none) continue;
      const Vec3 now = position(f_, i);
      n_.moved[i] = now - n_.position[slot];
      n_.change[i] = acceleration(world_, f_, i) - n_.acceleration[slot];
      fastest2_ = std::max(fastest2_, norm2(n_.moved[i]));
      Swing& swing = n_.swing[slot];
      if (!n_.kept_swing.empty() && is_young(n_.kept_swing[slot])) {
        if (!swing.begun) swing.add(n_.position[slot], time_within(world_, world_.stage.from), 1e-9);
        swing.add(now, time_within(world_, world_.stage.to), 1.0 / world_.sub_steps.count);
      }
      if (looked_at) n_.within[slot] = now - n_.moved[i] * (1.0 - within_);
    }
    for (const Attached& a : f_.attached) {
      const Receiver& m = f_.receivers[a.receiver];
      const double reach = reach_of(world_, m);
      if (reach > 0.0)
        n_.turning[a.site] = norm(m.torque + m.nonconservative_torque - m.noted_torque) / (reach * mass_of(world_, m));
    }
  }

  /// Whether this is the stage of the step in which positions are noted and forces of time are asked between its ends.
  bool is_looked_at() {
    const double at = fraction_of(world_.steps) * world_.sub_steps.count;
    within_ = at - std::floor(at);
    return static_cast<std::uint32_t>(at) == world_.stage.index;
  }

  /// Forces of time alone at the positions of the end, without noise, over the masses [m/s²] (sites).
  std::vector<Vec3> accelerations_at(double fraction) {
    std::fill(f_.sites.force.begin(), f_.sites.force.end(), zero3());
    std::fill(f_.sites.nonconservative_force.begin(), f_.sites.nonconservative_force.end(), zero3());
    Instant instant = instant_of(world_, time_within(world_, fraction), world_.instant);
    instant.silent = true;
    each_element(f_, [&](ActingElement& a) {
      if (a.law->timed && !a.law->thermal) run_law(world_, f_, a, instant);
    });
    collect(world_, f_);
    std::vector<Vec3> result(f_.sites.n);
    for (std::size_t i = 0; i < f_.sites.n; i++) result[i] = acceleration(world_, f_, i);
    return result;
  }

  /// A force whose period divides the stage is the same at both of its ends.
  void add_changes_of_time() {
    if (!is_looked_at()) return;
    const auto force = f_.sites.force, open = f_.sites.nonconservative_force;
    const StepStage& p = world_.stage;
    const auto from = accelerations_at(p.from), to = accelerations_at(p.to),
               between = accelerations_at(p.from + within_ * (p.to - p.from));
    f_.sites.force = force;
    f_.sites.nonconservative_force = open;
    collect(world_, f_);
    for (std::size_t i = 0; i < f_.sites.n; i++)
      for (const Vec3& end : {from[i], to[i]})
        if (norm2(between[i] - end) > norm2(n_.change[i])) n_.change[i] = between[i] - end;
  }

  void see(std::size_t site, double change, double size, bool told) {
    const double found = change * h_ / (6.0 * size), rate = std::isfinite(found) ? found : infinity;
    if (told && !std::isnan(found)) n_.told = std::max(n_.told, rate);
    if (rate <= worst_) return;
    worst_ = rate;
    n_.worst_site = site;
  }

  /// Adds up the errors of the most sub-steps until there is a size that they are relative to, which then tells them in the
  /// present stage.
  void tell_later(double& untold, double change, double size, bool known) {
    if (!known) {
      if (world_.sub_steps.count == sub_step_limit) untold += change * h_ * h_ / 6.0;
    } else if (untold > 0.0) {
      n_.told = std::max(n_.told, untold / (size * h_));
      n_.told_late = true;
      untold = 0.0;
    }
  }

  void see_jump(std::size_t site, double rate) {
    n_.jump = std::isfinite(rate) ? rate : infinity;
    if (n_.jump > worst_) n_.worst_site = site;
  }

  void judge_pair(std::uint32_t a, std::uint32_t b) {
    const double distance = norm(box_.nearest(f_.sites.x[b] - f_.sites.x[a]));
    n_.near[a] = std::min(n_.near[a], distance);
    n_.near[b] = std::min(n_.near[b], distance);
    const Vec3 change = n_.change[b] - n_.change[a];
    const double all = norm(change) + n_.turning[a] + n_.turning[b];
    if (all * h_ <= 6.0 * worst_ * distance || articulate_of(world_, f_, a) || articulate_of(world_, f_, b)) return;
    const Vec3 moved = n_.moved[b] - n_.moved[a];
    see(a, all, std::max(distance, swing_by(stiffness_along(change, moved), change, moved, h_)), true);
  }

  void judge_ties(const BondList& ties) {
    const auto count = static_cast<std::size_t>(ties.count);
    for (std::size_t k = 0; k < ties.sites.size(); k++)
      if (k % count != 0) judge_pair(ties.sites[k - 1], ties.sites[k]);
  }

  void judge_partners() {
    for (std::uint32_t i = 0; i < f_.sites.n; i++) {
      const std::uint32_t slot = f_.sites.particle[i];
      if (slot == Forces::none || slot >= n_.partner.size() || n_.partner[slot] == Forces::none) continue;
      const std::uint32_t j = f_.site_of[n_.partner[slot]];
      if (j != Forces::none) judge_pair(i, j);
    }
  }

  void judge_site(std::size_t i) {
    const std::uint32_t slot = f_.sites.particle[i];
    const Articulate* articulate = articulate_of(world_, f_, i);
    if (articulate && articulate->length_of_motion) {  // there it is judged as what is loose
      n_.change[i] = let_through(*articulate, f_.receivers[f_.attached[f_.attached_of[i]].receiver].node, n_.change[i]);
      articulate = nullptr;
    }
    const double change = norm(n_.change[i]) + n_.turning[i] + (articulate ? turned_by_rows(i, *articulate) : 0.0);
    const double jump = jump_before(slot, change / h_) * h_;
    n_.jerk[slot] = {change / h_, n_.jerk[slot][0], n_.jerk[slot][1]};
    if (change == 0.0 && jump == 0.0) return;
    if (articulate) return see(i, change, articulate->length, true);
    double size = std::isfinite(n_.near[i]) ? n_.near[i] : 0.0;
    if (f_.attached_of[i] != Forces::none)
      size = std::max(size, reach_of(world_, f_.receivers[f_.attached[f_.attached_of[i]].receiver]));
    const bool small = change * h_ <= 6.0 * std::min(worst_, n_.told) * size, soft = jump * h_ <= 4.0 * n_.jump * size;
    if (small && soft && n_.untold[slot] == 0.0) return;
    const double stiffness = stiffness_along(n_.change[i], n_.moved[i]);
    const Swing& swing = n_.swing[slot];
    size = std::max(size, swing.along(direction(n_.change[i])));
    // What has just begun to move may swing farther than it has until now.
    const double turned = turns(i, swing, stiffness, change / h_);
    if (turned < once_around) size = std::max(size, 2.0 * first_swing(i, stiffness));
    see(i, change, size, turned > half_around);
    tell_later(n_.untold[slot], change, size, turned > half_around);
    // Kicks are wrong by h/4 times a jump on average, and positions by that in each second from then on.
    if (jump * h_ > 4.0 * n_.jump * size) see_jump(i, jump * h_ / (4.0 * size));
  }

  /// What is left of a change of acceleration where rows tie a node to the world.
  static Vec3 let_through(const Articulate& a, std::uint32_t node, Vec3 change) {
    for (const std::uint32_t k : a.rows_on[node]) {
      const Row& row = a.rows[k];
      if (row.b >= 0) continue;
      if (is_rigid(row)) return zero3();
      if (!is_soft(row) && row.lever == 0.0) change -= condition(a, row).kept * change;
    }
    return change;
  }

  /// What rows make of a force that stays as it is changes as they turn with what they tie [m/s²].
  double turned_by_rows(std::size_t i, const Articulate& articulate) const {
    if (is_free(articulate)) return 0.0;
    const double moved = norm(n_.moved[i]), turn = std::min(1.0, moved / articulate.length);
    return std::min(norm(acceleration(world_, f_, i)), 2.0 * moved / (h_ * h_)) * turn;
  }

  /// By how much it has swung since it was first seen [rad]: by the stiffness that it meets, or by how fast its acceleration
  /// changes beside its size.
  double turns(std::size_t i, const Swing& swing, double stiffness, double jerk) const {
    if (!swing.begun) return 0.0;
    const double a = std::max(swing.acceleration, norm(acceleration(world_, f_, i))), j = std::max(swing.jerk, jerk);
    const double by_displacement = std::isfinite(stiffness) ? std::sqrt(stiffness) : 0.0;
    return (time_within(world_, world_.stage.to) - swing.since) * std::max(by_displacement, a > 0.0 ? j / a : 0.0);
  }

  /// How far it swings if its force changes on as in this stage; where laws of velocity act no farther than until they have
  /// stopped or turned it [m].
  double first_swing(std::size_t i, double stiffness) const {
    const double swing = swing_by(stiffness, n_.change[i], n_.moved[i], h_);
    if (!is_of_velocity(i)) return swing;
    const double a = norm(acceleration(world_, f_, i)), turning = norm(n_.change[i]) / (h_ * a);
    return std::min({swing, norm2(n_.moved[i]) / (h_ * h_ * a), a / (turning * turning)});
  }

  /// Whether laws of velocity are much of what moves a site.
  bool is_of_velocity(std::size_t i) const {
    if (!f_.velocity_dependent) return false;
    const double all = norm(f_.sites.force[i] + f_.sites.nonconservative_force[i]);
    return all > 0.0 && norm(f_.sites.nonconservative_force[i] - f_.still[i]) > 0.1 * all;
  }

  /// Change of the acceleration by its time [m/s³], where it jumped in the stage before, or in the two; 0 where it changed as it
  /// does before and after.
  double jump_before(std::uint32_t slot, double jerk) const {
    const auto [last, before, first] = n_.jerk[slot];
    if (!std::isfinite(before) || !(last > 3.0 * jerk)) return 0.0;
    if (last > 3.0 * before) return last;
    const double most = std::max(last, before);
    return most > 3.0 * first ? most : 0.0;
  }

  World& world_;
  Forces& f_;
  KickNotes& n_;
  Box box_;
  double h_;                             // [s]
  double worst_ = 0.0, fastest2_ = 0.0;  // [1/s], [m²]
  double within_ = 0.0;                  // where between the ends of the stage things are looked at
};

}  // namespace

double kick_error(World& world) {
  if (!world.forces) return 0.0;
  Forces& f = *world.forces;
  f.notes.told = f.notes.jump = 0.0;
  Judge judge(world, f);
  without_noise(world, f, [&] { judge.judge_all(); });
  for (const Encounter& met : find_encounters(world, f, judge.fastest(), judge.nearest())) judge.judge(met);
  f.notes.jumps_in_step += f.notes.jump * f.notes.jump;
  f.notes.told_in_step += f.notes.told * std::fabs(world.stage.h) / world.settings.step;
  return judge.worst();
}

std::string law_of_worst_error(World& world) {
  Forces& f = *world.forces;
  const KeptForces kept(f.sites);
  const std::size_t site = std::min(f.notes.worst_site, f.sites.n - 1);
  std::string name;
  double most = -1.0;
  each_element(f, [&](ActingElement& a) {
    std::fill(f.sites.force.begin(), f.sites.force.end(), zero3());
    std::fill(f.sites.nonconservative_force.begin(), f.sites.nonconservative_force.end(), zero3());
    run_law(world, f, a, instant_of(world, world.time, world.instant));
    const double pull = norm(f.sites.force[site] + f.sites.nonconservative_force[site]);
    if (!(pull > most)) return;
    most = pull;
    name = law_at_work(world, a);
  });
  return name;
}

}  // namespace pantin
