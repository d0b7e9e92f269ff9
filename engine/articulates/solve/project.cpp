#include "articulates/solve/project.hpp"
#include "articulates/fetch.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "articulates/solve/conditions.hpp"
#include "articulates/solve/couplings.hpp"
#include "articulates/solve/energy_return.hpp"
#include "articulates/solve/matrix.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/wanted_velocities.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// Sets the residual of a row to its forbidden velocity.
void find_forbidden_velocity(Articulate& a, std::size_t k) {
  Row& row = a.rows[k];
  row.residual = gather_for_row(a, k);
  if (row.condition < 0) return;
  const Condition& c = condition(a, row);
  row.residual -= c.wanted;
  if (!is_rigid(row)) row.residual = c.kept * row.residual;
}

/// Of a coupling's head that of the sum; of its other rows 0, which have the head's impulse.
Vec3 forbidden_of_coupling(const Articulate& a, std::uint32_t k) {
  for (const Coupling& coupling : a.couplings) {
    if (coupling.head != k) continue;
    return a.rows[k].residual +
           into_head(a, coupling, [&](const Row& row) { return gather_for_row(a, condition(a, row).row); });
  }
  return zero3();
}

/// What each row forbids at the arms at hand: kept, wanted, worked_at; of couplings into_head and from_head. A row that gives
/// way forbids nothing.
void set_velocity_constraints(Articulate& a) {
  for (Condition& c : a.conditions) c.wanted = c.worked_at = c.velocity;
  if (a.all_rigid) return;
  for (Row& row : a.rows) {
    if (is_rigid(row)) continue;
    Condition& c = condition(a, row);
    row.rule->project(row, c, c.held && !c.gives_way);
  }
  project_couplings(a);
  for (Condition& c : a.conditions) c.worked_at = c.wanted;
}

struct Velocities {
  double kinetic = 0.0;    // [J]
  double fastest = 0.0;    // [m/s] of nodes' centres and anchors
  double forbidden = 0.0;  // [m/s] largest of the rows
};

/// The batches' own momenta, or those of the nodes' starts, which they read.
enum class From : std::uint8_t { batches, nodes };

/// Sets the rows' residuals to their forbidden velocities, and takes these through the first half of a solution on the
/// factor at hand if asked for by `reuse`.
Velocities find_velocities(Articulate& a, From from, bool reuse = false) {
  Lanes kinetic = lanes(0.0), fastest2_of_nodes = lanes(0.0);
  double forbidden2 = 0.0;
  Tile done;
  clear_hubs(a);
  for (const Tile& tile : a.tiles) {
    for (; done.batches < tile.batches; done.batches++) {
      Fetch::some();
      if (from == From::nodes) read_momenta(a, done.batches);
      const NodeBatch& n = a.batches[done.batches];
      const Vec3x4 velocity = n.p * n.inverse_mass, spin = n.inverse_inertia_world * n.L;
      kinetic += (dot(velocity, n.p) + dot(spin, n.L)) * 0.5;
      fastest2_of_nodes = larger(norm2(velocity), fastest2_of_nodes);
      for (const RowEnds& end : ends_of(a, n))
        scatter_to_rows(a, end, (velocity + cross(spin, end.r1)) * end.sign + spin * end.lever);
    }
    for (; done.rows < tile.rows; done.rows++) {
      Row& row = a.rows[done.rows];
      find_forbidden_velocity(a, done.rows);
      if (is_coupled(row)) row.residual = forbidden_of_coupling(a, done.rows);
      forbidden2 = std::max(forbidden2, norm2(row.residual));
      a.right_side[done.rows] = row.residual * -1.0;
    }
    for (; reuse && done.columns < tile.columns; done.columns++)
      a.factor.substitute_forward(done.columns, a.right_side.data());
  }
  double fastest2 = largest_lane(fastest2_of_nodes);
  for (const Condition& c : a.conditions)
    fastest2 = std::max({fastest2, norm2(c.velocity), c.value_rate * c.value_rate});
  return {sum(kinetic), std::sqrt(fastest2), std::sqrt(forbidden2)};
}

/// What is driven was moved by the drift as fast as its residual says, and is as it is to be after: no tie that does not give
/// loses energy where a prescribed velocity jumps. Returns by how much the fastest does [m/s].
double set_driven_work_velocities(Articulate& a) {
  double jump = 0.0;
  for (Condition& c : a.conditions) {
    if (!c.driven || !c.held_before) continue;
    c.worked_at = c.wanted + row(a, c).residual * 0.5;
    jump = std::max(jump, norm(row(a, c).residual));
  }
  return jump;
}

/// Adds the work of the impulse of a row on what is prescribed.
void add_work(ImpulseWork& work, const Articulate& a, const Condition& c, Vec3 impulse) {
  if (c.stiff) return;
  (row(a, c).lever > 0.0 ? work.angular_rows : work.anchors) += dot(impulse, c.worked_at);
}

/// Energy that what is prescribed may give, if all moves as fast, or for a turn ten times as much, since a crank may turn
/// others faster than itself [J].
double driven_energy(const Articulate& a) {
  double energy = 0.0;
  for (const Condition& c : a.conditions) {
    const Row& r = row(a, c);
    const double speed2 = std::max(norm2(c.velocity), norm2(c.wanted));
    const Vec3 centre = a.nodes[static_cast<std::size_t>(r.a)].x0;
    energy = std::max(energy, r.lever > 0.0 ? 5.0 * inertia_about(a, centre) * speed2 / (r.lever * r.lever)
                                            : 0.5 * a.total_mass * speed2);
  }
  return energy;
}

/// Work of the impulses on what is prescribed. Where rows contradict each other their impulses may have no bound; the work at
/// the velocities after has one, and is told instead: to anchors, or to angular rows where none moves.
ImpulseWork work_of_impulses(const Articulate& a, const Velocities& before, const Velocities& after) {
  constexpr double bound = 10.0;  // of what moves and drives
  ImpulseWork work;
  for (const Condition& c : a.conditions) add_work(work, a, c, a.impulses[c.row]);
  const bool solved = after.forbidden <= 1e-6 * std::max(after.fastest, before.forbidden);
  if (solved || std::fabs(work.all()) <= bound * (after.kinetic + driven_energy(a))) return work;
  work = {};
  bool anchors = false;
  double all = 0.0;
  for (std::size_t k = 0; k < a.rows.size(); k++) all += dot(a.impulses[k], a.rows[k].residual);
  for (const Condition& c : a.conditions) {
    all += dot(a.impulses[c.row], c.wanted);
    anchors = anchors || (row(a, c).lever == 0.0 && norm2(c.wanted) > 0.0);
  }
  (anchors ? work.anchors : work.angular_rows) = all;
  return work;
}

/// The solved impulse of a row, along what it may forbid.
Vec3 solved_impulse(const Articulate& a, std::uint32_t k) {
  if (is_rigid(a.rows[k])) return a.right_side[k];
  return condition(a, a.rows[k]).kept * a.right_side[k];
}

/// Finishes the solution of the half solved right side and applies the impulses.
ImpulseWork apply_projection(Articulate& a) {
  const auto impulse = [&](std::uint32_t k) { return a.all_rigid ? a.right_side[k] : solved_impulse(a, k); };
  std::size_t b = a.batches.size();
  solve_hubs(a);
  for (auto k = static_cast<std::uint32_t>(a.rows.size()); k-- > 0;) {
    a.factor.substitute_back(k, a.right_side.data());
    a.impulses[k] += impulse(k);
    for (; b > 0 && a.batches[b - 1].first_row == k; b--) add_impulses(a, a.batches[b - 1], impulse);
  }
  ImpulseWork work;
  for (const Condition& c : a.conditions) add_work(work, a, c, impulse(c.row));
  return work;
}

void tell_momenta(Articulate& a) {
  for (std::size_t b = 0; b < a.batches.size(); b++) tell_momenta(a, b);
}

/// Fills and factorises S1 at the nodes' starts for what the rows forbid there; what settles has 1/m_s on its diagonal.
void factorise_projection(Articulate& a, double epsilon) {
  set_kept_matrices(a);
  for (Node& n : a.nodes) set_end_from_start(n);
  double scale = 0.0;
  if (!a.all_rigid)
    for (const Row& row : a.rows) scale = std::max(scale, mobility(a, row));
  for (Condition& c : a.conditions)
    if (c.settles) c.C += c.kept * (1.0 / (c.settling * scale));
  factorise(a, {.right = Arms::end, .epsilon = epsilon, .times_C = scale, .times_residual = -1.0});
}

/// Whether the rows of Newton's matrix forbid the velocities that projections do.
bool forbids_as_newton(const Articulate& a) {
  return a.all_rigid ||
         std::all_of(a.rows.begin(), a.rows.end(), [](const Row& row) { return row.rule->forbids_as_newton; });
}

/// Whether the step's own factor, a cheap approximation of S1, may serve.
bool may_use_newton_factor(Articulate& a) {
  if (a.factor_of != FactorOf::newton || !forbids_as_newton(a)) return false;
  if (a.projection_wait == 0) return true;
  a.projection_wait--;
  return false;
}

/// Uses it up to three times, first on the half solved right side; false where it does not serve.
bool project_with_newton_factor(Articulate& a, const Velocities& before, DriftReport& report) {
  ImpulseWork done;
  for (int i = 0; i < 3; i++) {
    done += apply_projection(a);
    const Velocities after = find_velocities(a, From::batches);
    if (after.forbidden > 0.2 * before.forbidden + 1e-12 * before.fastest) {
      for (std::uint32_t k = 0; k < a.factor.rows; k++) a.factor.substitute_forward(k, a.right_side.data());
      continue;
    }
    if (after.kinetic > before.kinetic * (1.0 + 1e-12) + std::fabs(done.all())) break;
    report.tell(done);
    return true;
  }
  std::fill(a.impulses.begin(), a.impulses.end(), zero3());
  find_velocities(a, From::nodes);
  a.projection_wait = 100;
  return false;
}

/// Λ̂ = ½ (Λ̂ + Λ), along what is kept now, for sub-steps of h [s]; with the work of it on what is prescribed.
void average_impulses(Articulate& a, double h) {
  a.symmetric_h = h;
  for (std::size_t k = 0; k < a.rows.size(); k++)
    a.symmetric_impulses[k] = (a.symmetric_impulses[k] + a.impulses[k]) * 0.5;
  a.symmetric_work = {};
  for (const Condition& c : a.conditions)
    if (!is_rigid(row(a, c)))
      a.symmetric_impulses[c.row] = c.kept * a.symmetric_impulses[c.row];  // earlier ones were along others
  for (const Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows)
      if (k != coupling.head)
        a.symmetric_impulses[k] = condition(a, a.rows[k]).from_head * a.symmetric_impulses[coupling.head] * -1.0;
  for (const Condition& c : a.conditions) add_work(a.symmetric_work, a, c, a.symmetric_impulses[c.row]);
}

/// Whether what was struck is a stop, and no motor that reached its speed.
bool is_stopped(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(),
                     [](const Condition& c) { return c.ranged && c.held && !c.held_before; });
}

/// Whether some rows may let go or begin to hold.
bool is_one_sided(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(),
                     [](const Condition& c) { return c.ranged || !std::isinf(c.upper); });
}

/// Whether there are stops, or a motor reaches its limit or leaves it: then none of the impulses is carried to the next step.
bool may_let_go(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) {
    return c.ranged || (!std::isinf(c.upper) && (c.held != c.held_before || c.gives_way));
  });
}

/// Whether something prescribed moves: the drift goes past its velocity as far as the projection takes it back.
bool is_driven(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.driven; });
}

}  // namespace

void set_kept_matrices(Articulate& a) {
  for (Row& row : a.rows) {
    if (is_rigid(row)) continue;
    Condition& c = condition(a, row);
    c.M = c.kept;
    c.C = identity33() - c.kept;
  }
  for (const Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows) {
      if (k == coupling.head) continue;
      condition(a, a.rows[k]).M = zero33();
      condition(a, a.rows[k]).C = identity33();
    }
}

bool project_symmetrically(Articulate& a, double full, DriftReport& report) {
  a.symmetric_energy = 0.0;
  if (a.symmetric_h != full / a.sub_steps.count) {
    std::fill(a.symmetric_impulses.begin(), a.symmetric_impulses.end(), zero3());
    return false;
  }
  const double sign = symmetric_sign(a);
  report.tell(a.symmetric_work, sign);
  Lanes gained = lanes(0.0);
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    NodeBatch& n = a.batches[b];
    read_momenta(a, b);
    const Lanes before = kinetic_energy(n);
    add_impulses(a, n, [&](std::uint32_t k) { return a.symmetric_impulses[k] * sign; });
    tell_momenta(a, b);
    gained += kinetic_energy(n) - before;
  }
  a.symmetric_energy = sum(gained);
  report.energy_projected += a.symmetric_energy - a.symmetric_work.all() * sign;
  return true;
}

namespace {

Vec3 spin_of(const Node& n) { return n.R0 * (n.inverse_inertia * n.P0); }

/// A motor that gave all its force over all of the drift, and by that went past its speed, holds it: less would have done.
void hold_what_went_past(Articulate& a) {
  for (Condition& c : a.conditions) {
    const Row& r = row(a, c);
    if (c.held || !c.by_speed || !is_limited(c) || !std::isinf(c.stall_force)) continue;
    c.wanted = c.velocity;
    r.rule->project(r, c, true);
    const Vec3 spin = spin_of(a.nodes[static_cast<std::size_t>(r.a)]) -
                      (r.b < 0 ? zero3() : spin_of(a.nodes[static_cast<std::size_t>(r.b)]));
    c.held = dot(c.kept * spin * r.lever - c.wanted, r.f) > 0.0;
  }
}

/// What touches, or arrives, may stop a motor more suddenly than its force could. Of what touches that is found out beside its
/// contacts, later.
void let_overdriven_give_way(Articulate& a, double h) {
  for (Condition& c : a.conditions) c.gives_way = a.touches && is_limited(c);
  if (a.touches || std::none_of(a.conditions.begin(), a.conditions.end(), is_limited)) return;
  begin_answers(a, 0.0);
  for (std::size_t b = 0; b < a.batches.size(); b++) read_momenta(a, b);
  answer(a);
  let_answers_give_way(a, h);
  a.factor_of = FactorOf::none;
}

}  // namespace

void project_articulate(Articulate& a, const DriftSettings& settings, DriftReport& report) {
  std::optional<WantedVelocities> as_now;
  if (settings.to != 1.0) as_now.emplace(a, settings.step, settings.to);
  a.symmetric_h = 0.0;
  const bool at_distance = acts_at_distance(a);
  Momenta momenta = at_distance ? momenta_of(a) : Momenta{};
  momenta.angular -= std::exchange(a.angular_at_distance, zero3());
  if (a.fell_back || a.forbids_nothing) {
    if (at_distance) report.hand += restore_momenta(a, momenta);
    return;
  }
  if (!a.touches) hold_what_went_past(a);
  let_overdriven_give_way(a, settings.full);
  std::fill(a.impulses.begin(), a.impulses.end(), zero3());
  set_velocity_constraints(a);
  bool reuse = may_use_newton_factor(a);
  const Velocities before = find_velocities(a, From::nodes, reuse);
  const double speed = std::max(before.fastest, std::sqrt(norm(settings.gravity) * a.length));
  // part of the speed: a jump by more is taken out exactly, and no half of it carried
  constexpr double largest_carried_jump = 1e-2;
  const bool jumps = set_driven_work_velocities(a) > largest_carried_jump * speed;
  if (jumps && std::exchange(reuse, false)) find_velocities(a, From::nodes);
  const double outside = report.outside();
  if (!reuse || !project_with_newton_factor(a, before, report)) {
    report.exact_projections++;
    drop_factor(a, FactorOf::newton);
    if (a.factor_of == FactorOf::projection)
      find_velocities(a, From::nodes, true);
    else
      factorise_projection(a, a.least_epsilon);
    const ImpulseWork done = apply_projection(a);
    const bool strikes = struck(a);
    if (done.all() != 0.0 || strikes) {
      const Velocities after = find_velocities(a, From::batches);
      const ImpulseWork work = work_of_impulses(a, before, after);
      report.tell(work);
      if (strikes) (is_stopped(a) ? report.limit : report.motor) += after.kinetic - before.kinetic - work.all();
    }
  }
  tell_momenta(a);
  if (at_distance) {
    const double given = restore_momenta(a, momenta);
    report.hand += a.attracts ? kinetic_energy(a) - before.kinetic - (report.outside() - outside) : given;
  }
  const bool one_sided = is_one_sided(a);
  if (!a.sums_impulses && (one_sided || is_driven(a))) {
    begin_exerted(a);
    add_forces_exerted(a, settings.full);
  }
  if (a.sums_impulses) add_impulses_exerted(a);
  const bool negligible = before.forbidden <= 1e-9 * speed;  // as small as what the solver leaves
  if (a.smooth && !jumps && !a.weak && !negligible && !at_distance && !may_let_go(a) && !a.touches)
    average_impulses(a, settings.full / a.sub_steps.count);
  if (settings.energy_return)
    report.returned += return_energy(a, before.kinetic - a.symmetric_energy, settings.gravity);
}

namespace {

/// Takes out what the rows that hold forbid; returns the work of what is prescribed.
ImpulseWork take_out_forbidden(Articulate& a) {
  set_velocity_constraints(a);
  const double driven = driven_energy(a);
  ImpulseWork work;
  for (double epsilon = a.least_epsilon;; epsilon *= 100.0) {
    std::fill(a.impulses.begin(), a.impulses.end(), zero3());
    Velocities v = find_velocities(a, From::nodes);
    const Velocities before = v;
    set_driven_work_velocities(a);
    if (v.forbidden <= 1e-13 * v.fastest) return work;
    const double most_energy = std::max(1.001 * v.kinetic, driven);  // more is of a pivot that is too weak
    factorise_projection(a, epsilon);
    a.report.factorisations++;
    for (int i = 0; i < 3; i++) {
      const double last = v.forbidden;
      if (last < 1e-13 * v.fastest) break;
      apply_projection(a);
      v = find_velocities(a, From::batches, true);
      if (v.forbidden > 0.5 * last) break;
    }
    work = work_of_impulses(a, before, v);
    if (v.kinetic <= most_energy || epsilon > 1e-3) return work;
  }
}

/// How much of its impulse a row that holds cannot give [N s]; `time` [s] it has for it. A stop that was struck for `struck_for`
/// [s] gave an impulse there, of which this may take back a part: the impact turned what it should end.
double impulse_beyond(const Articulate& a, const Condition& c, double time, double struck_for) {
  const Row& r = row(a, c);
  const Vec3 impulse = a.impulses[c.row];
  if (c.ranged) return -dot(c.held_before ? impulse : impulse + r.f * struck_for, stop(a, r).inward);
  return std::isinf(c.upper) ? 0.0 : norm(impulse) - c.upper * time;
}

/// Has the row that can give its impulse least let go, or, once as many as `gone` have, all that cannot; false where all can.
bool let_one_go(Articulate& a, double time, double struck_for, int gone) {
  constexpr int one_by_one = 8;
  Condition* worst = nullptr;
  double most = 0.0;
  for (Condition& c : a.conditions) {
    if (!c.held || c.stiff) continue;
    const double beyond = impulse_beyond(a, c, time, struck_for);
    if (beyond <= 1e-12 * norm(a.impulses[c.row])) continue;
    if (gone >= one_by_one) c.held = false;
    if (beyond > most) worst = &c;
    most = std::max(most, beyond);
  }
  if (worst == nullptr) return false;
  worst->held = false;
  hold_with_heads(a);
  return true;
}

}  // namespace

ImpulseWork make_consistent(Articulate& a, double time, double struck_for) {
  std::fill(a.impulses.begin(), a.impulses.end(), zero3());
  if (a.forbids_nothing) return {};
  ImpulseWork work = take_out_forbidden(a);
  for (int gone = 0; let_one_go(a, time, struck_for, gone); gone++) work = take_out_forbidden(a);
  tell_momenta(a);
  drop_factor(a, FactorOf::newton);
  if (a.sums_impulses) add_impulses_exerted(a);
  return work;
}

void place_velocity_constraints(Articulate& a, double step, double at, double wanted_at) {
  set_conditions(a, step, at, at);
  const WantedVelocities wanted(a, step, wanted_at);
  for (Node& n : a.nodes) set_end_from_start(n);
  place_rows_at_end(a);
  set_velocity_constraints(a);
}

void begin_answers(Articulate& a, double epsilon) {
  if (a.factor_of != FactorOf::projection) {
    for (Node& n : a.nodes) set_end_from_start(n);
    place_rows_at_end(a);
  }
  set_velocity_constraints(a);
  if (a.factor_of == FactorOf::projection) return;
  factorise_projection(a, std::max(epsilon, a.least_epsilon));
  a.factor_of = FactorOf::projection;
}

void keep_driven_velocities(Articulate& a) {
  constexpr double least_jump = 0.1;  // part of the speed
  find_velocities(a, From::batches);
  for (Condition& c : a.conditions) {
    if (!c.driven) continue;
    const Vec3 now = c.wanted + row(a, c).residual;
    const double fastest = std::max({norm(c.wanted), norm(now), norm(c.velocity)});
    if (norm(now - c.wanted) > least_jump * fastest) c.worked_at = now;
    c.wanted = now;
  }
}

ImpulseWork answer(Articulate& a) {
  std::fill(a.impulses.begin(), a.impulses.end(), zero3());
  find_velocities(a, From::batches, true);
  return apply_projection(a);
}

void let_answers_give_way(Articulate& a, double h) {
  for (Condition& c : a.conditions)
    c.gives_way = c.gives_way || (is_limited(c) && norm(a.impulses[c.row]) > c.upper * h);
}

}  // namespace pantin
