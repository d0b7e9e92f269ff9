#include "articulates/solve/fallback_step.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/ends_at_anchors.hpp"
#include "articulates/solve/energy_return.hpp"
#include "articulates/solve/loose.hpp"
#include "articulates/solve/matrix.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "base/functions.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

namespace {

/// Kinetic, and potential in gravity, [J].
double mechanical_energy(const Articulate& a, Vec3 gravity) {
  double energy = kinetic_energy(a);
  for (const Node& n : a.nodes) energy -= n.mass * dot(gravity, n.x0);
  return energy;
}

/// What pulls by a law keeps its length in a fallback step.
void hold_stiff(Articulate& a) {
  for (Row& row : a.rows)
    if (pulls_by_law(row)) hold_length(row, condition(a, row));
  a.forbids_nothing = false;
}
/// It pulls again.
void release_stiff(Articulate& a) {
  for (Row& row : a.rows)
    if (row.condition >= 0 && condition(a, row).stiff) pull_again(row);  // its rule is not by a law now
  a.forbids_nothing = std::all_of(a.rows.begin(), a.rows.end(), is_soft);
  measure_gaps(a);
}

/// Impulses of soft rows, pushes and twists, whose work it tells; then that of gravity.
void kick(Articulate& a, double h, Vec3 gravity, DriftReport& report) {
  const double before = kinetic_energy(a);
  for (Row& row : a.rows) {
    row.f = zero3();
    if (!is_soft(row)) continue;
    row.f = row.rule->pull(row, condition(a, row), {h, mobility(a, row)});
    const auto pull_node = [&](std::int32_t node, Vec3 arm, Vec3 f) {
      Node& n = a.nodes[static_cast<std::size_t>(node)];
      n.p0 += f * h;
      if (n.turns) n.P0 += transposed_times(n.R0, cross(n.R0 * arm, f)) * h;
    };
    pull_node(row.a, row.la, row.f);
    if (row.b >= 0) pull_node(row.b, row.lb, row.f * -1.0);
  }
  for (Node& n : a.nodes) {
    n.p0 += (n.force - gravity * n.mass) * h;
    n.P0 += transposed_times(n.R0, n.torque) * h;
    n.spin0 = n.inverse_inertia * n.P0;
  }
  report.hand += kinetic_energy(a) - before;
  for (Node& n : a.nodes) n.p0 += gravity * (n.mass * h);
}

/// What stops something, and held it or is passed, holds; the motion tells whether it lets go.
void hold_stops(Articulate& a) {
  for (Row& row : a.rows) {
    if (row.condition < 0) continue;
    Condition& c = condition(a, row);
    if (!c.ranged && std::isinf(c.upper)) continue;
    c.held = (c.held_before || (c.ranged && stop(a, row).room < 0.0)) && std::isinf(c.stall_force);
  }
  hold_with_heads(a);
}

/// Which rows close their gaps: all, or all but those that give way.
enum class Closing { all, what_stays };

/// Sets the residuals of the rows to their gaps, and M and C for a solve in the mass metric; returns Σ g² [m²].
double find_gaps(Articulate& a, Closing closing = Closing::all) {
  place_rows_at_end(a);
  double sum = 0.0;
  for (Row& row : a.rows) {
    row.residual = gap(a, row);
    if (!is_rigid(row)) {
      Condition& c = condition(a, row);
      if (c.ranged || !std::isinf(c.upper)) c.held = c.ranged && stop(a, row).room < 0.0;
      c.held_before = c.held_before || c.held;
      row.rule->project(row, c, c.held);
      if (closing == Closing::what_stays && c.gives_way && !c.ranged) {
        row.residual = zero3();
        c.kept = zero33();
      }
    }
    sum += norm2(row.residual);
  }
  project_couplings(a);
  set_kept_matrices(a);
  return std::isfinite(sum) ? sum : infinity;
}

/// The nodes' ends become their starts, and the solved Λ in `right_side` moves the ends on: by M⁻¹ G1'Λ, or by shifts alone.
void move_by_solution(Articulate& a, bool may_turn) {
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    NodeBatch& n = a.batches[b];
    n.p = n.L = zero3x4();
    add_impulses(a, n, [&](std::uint32_t k) { return a.right_side[k]; });
    const auto straight = unpack(n.p), turning = unpack(n.L);
    for (std::size_t lane = 0; lane < n.count; lane++) {
      Node& node = a.nodes[batch_size * b + lane];
      set_start_from_end(node);
      node.x1 = node.x0 + straight[lane] * node.inverse_mass;
      if (!node.turns || !may_turn) continue;
      const Vec3 u = congruent(node.R0, node.inverse_inertia) * turning[lane] * 0.5;
      node.q1 = normalised(Quat{1.0, u[0], u[1], u[2]} * node.q0);
      node.R1 = matrix(node.q1);
    }
  }
}

/// One step of Levenberg and Marquardt from the gaps at hand, in which nodes may turn or are only shifted. Returns Σ g²
/// after it [m²].
double try_to_close(Articulate& a, double epsilon, double scale, bool may_turn, Closing closing) {
  factorise(a,
            {.right = Arms::end, .epsilon = epsilon, .times_C = scale, .times_residual = -1.0, .may_turn = may_turn});
  a.report.iterations++;
  a.report.factorisations++;
  solve_hubs(a);
  for (std::size_t k = a.rows.size(); k-- > 0;)
    a.factor.substitute_back(static_cast<std::uint32_t>(k), a.right_side.data());
  move_by_solution(a, may_turn);
  return find_gaps(a, closing);
}

/// Closes the gaps of the nodes' ends as far as it can. Where turns lead no further, one shift may: without loops it
/// closes all.
void close_gaps(Articulate& a, double tolerance, int& tries_left, Closing closing = Closing::all) {
  const double least = std::min(1e-12, a.least_epsilon);
  double sum = find_gaps(a, closing), epsilon = 1e-6, scale = 0.0;
  if (!a.all_rigid)
    for (const Row& row : a.rows) scale = std::max(scale, mobility(a, row));
  bool slow = false, shifted = false;
  for (; tries_left > 0 && sum > tolerance * tolerance; tries_left--) {
    const bool may_turn = epsilon <= 1e3 && !slow;
    if (!may_turn && shifted) break;
    shifted = shifted || !may_turn;
    const double now = try_to_close(a, may_turn ? epsilon : least, scale, may_turn, closing);
    if (now < sum) {
      epsilon = may_turn ? std::max(least, 0.02 * epsilon) : 1e-6;
      slow = may_turn && epsilon == least && now > 0.998 * sum;
      sum = now;
      continue;
    }
    for (Node& n : a.nodes) set_end_from_start(n);
    find_gaps(a, closing);
    epsilon *= 20.0;
  }
  measure_gaps(a);
}

/// Moves the nodes freely over a fraction (0 … 1) of h [s].
void move_freely(Articulate& a, double h, double fraction) {
  for (Node& n : a.nodes) {
    const Vec3 P = n.P0;
    n.x0 += n.p0 * (h * fraction * n.inverse_mass);
    if (n.turns && fraction > 0.0) turn_freely(n, h * fraction);
    set_end_from_start(n);
    if (fraction < 1.0) n.P0 = P;
  }
}

/// Drifts freely, then closes the gaps as far as it can. Where that leaves more open than standing still would, the
/// motion was too wild: again from the start over a quarter of it, a sixteenth, and in the end not at all.
void drift_and_close(Articulate& a, double h, double tolerance) {
  find_gaps(a);
  double allowed = largest_closed_gap(a);
  for (const Row& row : a.rows) allowed = std::max(allowed, 1.01 * norm(row.residual));
  const int most = a.torn ? 60 : a.fell_back ? 36 : 12;  // the next step goes on
  for (double fraction = 1.0;; fraction = fraction > 0.2 ? 0.25 * fraction : 0.0) {
    move_freely(a, h, fraction);
    int tries_left = fraction == 1.0 ? most : 4;
    close_gaps(a, tolerance, tries_left);
    if (a.gaps.unaccepted <= allowed || fraction == 0.0) return;
    a.nodes = a.saved;
  }
}

/// Shifts all to a centre of mass.
void shift_to(Articulate& a, Vec3 centre) {
  const Vec3 by = centre - centre_of_mass(a);
  for (Node& n : a.nodes) {
    n.x0 += by;
    n.x1 = n.x0;
  }
}

/// Whether no anchor moves, and no value that a row keeps changes.
bool nothing_driven(const Articulate& a) {
  return std::all_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) {
    return norm2(c.velocity) == 0.0 && c.value_rate == 0.0 && same(c.whole0, c.whole1);
  });
}

/// Takes the step back: all rest where they were but for uncoupled spin; what is free moves on as one rigid body with its momenta.
void stay(Articulate& a, double h, bool free, const Momenta& momenta) {
  a.nodes = a.saved;
  if (free) shift_to(a, centre_of_mass(a) + momenta.p * (h / a.total_mass));
  for (Node& n : a.nodes) {
    n.p0 = zero3();
    n.P0 = n.P0 - n.P0 * n.felt_axes;
    n.spin0 = n.inverse_inertia * n.P0;
    set_end_from_start(n);
  }
  find_gaps(a);
  measure_gaps(a);
  if (free) restore_momenta(a, momenta);
}

/// Energy that forces and pulls do not explain is taken out of the motion again, and so is what was carried over from the
/// last projection, which no projection will take now. What the motion has not, anchors that move have given, and where
/// none does it does not go there.
class OnlyDissipates {
 public:
  OnlyDissipates(Articulate& a, Vec3 gravity, DriftReport& report)
      : a_(a), gravity_(gravity), report_(report), before_(unexplained_energy()) {}

  double change() const { return unexplained_energy() - before_; }
  /// Whether the motion had enough of it.
  bool take_out() {
    const double too_much = change() + std::max(a_.symmetric_energy, 0.0);
    if (too_much > 0.0) change_kinetic_energy(a_, -too_much, 1.0, gravity_);
    return change() <= 1e-12 * kinetic_energy(a_);
  }
  /// On the line of limits where one was `met`.
  void tell(bool met) {
    a_.symmetric_energy = 0.0;
    (met ? report_.limit : report_.dissipated) += change();
  }

 private:
  double unexplained_energy() const { return mechanical_energy(a_, gravity_) - report_.outside(); }

  Articulate& a_;
  Vec3 gravity_;
  DriftReport& report_;
  double before_;
};

/// [rad] Of a turn, half of one at most.
Vec3 rotation_of(const Quat& q) {
  const Vec3 axis = vec(q.x, q.y, q.z) * (q.w < 0.0 ? -1.0 : 1.0);
  return direction(axis) * (2.0 * functions::atan2(norm(axis), std::fabs(q.w)));
}

/// Whether a thing moved much less far than its velocities at both ends of a step say.
bool is_stuck(Vec3 moved, Vec3 before, Vec3 after) {
  constexpr double much_less = 0.25;
  const Vec3 told = (before + after) * 0.5;
  return dot(moved, told) < much_less * norm2(told);
}

Vec3 at_most(Vec3 v, double size) { return norm(v) > size ? v * (size / norm(v)) : v; }

/// Where a node, which began the step as `before`, could not go or turn as its velocities say, what is left of them is what it
/// moved by; what all have in `common` is not counted [m/s]. Whether it was so.
bool stop_stuck(Node& n, const Node& before, double h, Vec3 common) {
  const Vec3 v = n.p0 * n.inverse_mass - common, moved = (n.x0 - before.x0) / h - common;
  const bool stays = is_stuck(moved, before.p0 * n.inverse_mass - common, v);
  if (stays) n.p0 = (common + at_most(moved, norm(v))) * n.mass;
  constexpr double most_told = 3.0;  // [rad] beyond it two orientations do not tell how far it turned
  if (!n.turns || norm(n.spin0) * h > most_told) return stays;
  const Vec3 spin = n.R0 * n.spin0, turned = rotation_of(n.q0 * conjugate(before.q0)) / h;
  if (!is_stuck(turned, before.R0 * before.spin0, spin)) return stays;
  n.P0 += (n.inertia * transposed_times(n.R0, at_most(turned, norm(spin))) - n.P0) * n.felt_axes;
  n.spin0 = n.inverse_inertia * n.P0;
  return true;
}

Mat3 kept_of(const Articulate& a, const Row& row) { return is_rigid(row) ? identity33() : condition(a, row).kept; }

/// The rows that tie a node to the world bear what stopped it [N s], as far as they can, where no others do.
void bear(Articulate& a, std::size_t node, Vec3 impulse) {
  const auto id = static_cast<std::int32_t>(node);
  const auto bears = [&](const Row& row) { return (row.a == id || row.b == id) && !is_soft(row) && row.lever == 0.0; };
  Mat3 all = identity33() * 1e-9;
  for (const Row& row : a.rows) {
    if (!bears(row)) continue;
    if (row.b >= 0) return;
    all += kept_of(a, row);
  }
  const Vec3 shared = inverse(all) * impulse;
  for (std::size_t k = 0; k < a.rows.size(); k++)
    if (bears(a.rows[k])) a.exerted[k] += kept_of(a, a.rows[k]) * shared;
}

/// What could not move as it is told to is stopped, in an inelastic impact; whether that was of limits, which hold it.
bool stop_what_stays(Articulate& a, double h, Vec3 common, DriftReport& report) {
  bool some = false, limited = false;
  for (std::size_t i = 0; i < a.nodes.size(); i++) {
    const Vec3 p = a.nodes[i].p0;
    if (!stop_stuck(a.nodes[i], a.saved[i], h, common)) continue;
    some = true;
    if (a.sums_impulses) bear(a, i, a.nodes[i].p0 - p);
    const auto id = static_cast<std::int32_t>(i);
    limited = limited || std::any_of(a.conditions.begin(), a.conditions.end(), [&](const Condition& c) {
                return c.ranged && c.held && (row(a, c).a == id || row(a, c).b == id);
              });
  }
  if (some) report.tell(make_consistent(a, h));
  return limited;
}

/// The first projection of a fallback step. Ends of strings at their anchors stay if they can.
void make_start_of_fallback_consistent(Articulate& a, double h, EndsAtAnchors& ends, DriftReport& report) {
  if (ends.none()) return report.tell(make_consistent(a, h));
  const std::vector<Vec3> exerted = a.exerted;
  const std::vector<Node> nodes = a.nodes;
  ends.fix();
  ImpulseWork work = make_consistent(a, h);
  if (ends.let_go()) {
    for (std::size_t i = 0; i < a.nodes.size(); i++)
      if (a.nodes[i].inverse_mass == nodes[i].inverse_mass)
        std::tie(a.nodes[i].p0, a.nodes[i].P0, a.nodes[i].spin0) = std::tie(nodes[i].p0, nodes[i].P0, nodes[i].spin0);
    a.exerted = exerted;
    place_rows_at_start(a);
    place_rows_at_end(a);
    hold_stops(a);
    work = make_consistent(a, h);
  }
  ends.rest();
  report.tell(work);
}

/// A small gap that stays (a loop built a little too long) becomes the row's constant offset: not one that is passing, nor
/// one of rows without loops, which can always be closed.
void accept_gaps(Articulate& a, double tolerance, DriftReport& report) {
  if (a.loop_free || !nothing_driven(a) || !is_open(a) || a.gaps.unaccepted > tolerance * a.length) return;
  for (Row& row : a.rows)
    if (!is_soft(row)) accept_gap(a, row);
  a.has_offsets = true;
  report.offsets_accepted++;
  measure_gaps(a);
}

}  // namespace

bool close_displaced(Articulate& a) {
  constexpr int most = 6;
  constexpr double most_open = 2e-2;  // of the length: more than a displacement opens in the second order
  const std::vector<Row> rows = a.rows;
  const std::vector<Condition> conditions = a.conditions;
  const Gaps before = a.gaps;
  for (Node& n : a.nodes) set_end_from_start(n);
  place_rows_at_start(a);
  hold_stiff(a);
  std::vector<Vec3> angular;
  for (const Node& n : a.nodes) angular.push_back(n.R0 * n.P0);
  int tries_left = std::sqrt(find_gaps(a, Closing::what_stays)) <= most_open * a.length ? most : 0;
  close_gaps(a, 1e-13 * a.length, tries_left, Closing::what_stays);
  if (tries_left < most) {
    for (std::size_t i = 0; i < a.nodes.size(); i++)
      if (a.nodes[i].turns) a.nodes[i].P0 = transposed_times(a.nodes[i].R1, angular[i]);
    for (Node& n : a.nodes) set_start_from_end(n);
  }
  release_stiff(a);
  a.rows = rows;
  a.conditions = conditions;
  drop_factor(a, FactorOf::newton);
  const bool tried = tries_left < most, closed = a.gaps.unaccepted <= 1e-9 * a.length;
  if (!tried) a.gaps.unaccepted = before.unaccepted;  // the next drift closes what is told
  if (!tried || closed) return true;
  a.nodes = a.saved;
  a.gaps = before;
  return false;
}

void fallback_step(Articulate& a, const DriftSettings& settings, double h, DriftReport& report) {
  if (!std::isfinite(kinetic_energy(a))) return;  // the end of the step tells what is beyond all numbers
  OnlyDissipates energy(a, settings.gravity, report);
  place_rows_at_start(a);
  hold_stiff(a);
  for (Node& n : a.nodes) set_end_from_start(n);
  EndsAtAnchors ends(a);
  ends.take(h);
  kick(a, h, settings.gravity, report);
  const bool free = is_free(a);
  for (Condition& c : a.conditions) c.run = {};
  const Momenta momenta = momenta_of(a);
  const Vec3 centre = centre_of_mass(a) + momenta.p * (h / a.total_mass);
  place_rows_at_end(a);
  hold_stops(a);
  make_start_of_fallback_consistent(a, h, ends, report);
  for (Condition& c : a.conditions) c.held_before = c.held;
  a.saved = a.nodes;
  drift_and_close(a, h, 1e-9 * h * std::sqrt(norm(settings.gravity) * a.length) + 1e-12 * a.length);
  for (Node& n : a.nodes) set_start_from_end(n);
  if (free) shift_to(a, centre);
  accept_gaps(a, settings.tolerance, report);
  for (Condition& c : a.conditions) c.held = c.held_before;
  report.tell(make_consistent(a, h));
  const bool may_stop = a.fell_back && !a.torn && nothing_driven(a);
  const bool stopped = may_stop && stop_what_stays(a, h, free ? momenta.p / a.total_mass : zero3(), report);
  ends.rest();
  if (free) restore_momenta(a, momenta);
  if (!energy.take_out() && !a.torn) {
    if (nothing_driven(a))
      stay(a, h, free, momenta);
    else
      report.hand += energy.change();
  }
  ends.release();
  energy.tell(stopped || ends.met());
  for (Row& row : a.rows)
    if (!is_soft(row)) row.f = zero3();
  for (Condition& c : a.conditions) c.angle0 = c.angle1;
  release_stiff(a);
  a.last_h = 0.0;
  a.fell_back = true;
  report.fallbacks++;
}

}  // namespace pantin
