// Several values add up to one, Σ w v = L: lengths of a string's segments, turns of gears, distances along an axis of racks. What makes
// force times displacement exact for a value is its discrete gradient e: of a length (d0 + d1)/(|d0| + |d1|), of a distance
// along an axis the mean of that axis, of an angle that turns by φ the axis n times φ/(n·(a_a - a_b)), for that is what a torque does work on. So the
// forces are λ w e with one λ for all: what the coupling gives on one side it takes on the other, without work.
//   head:   n (Σ w v - L) + κ P f = 0, or f = 0 where it is one-sided and slack;   n = e/|e|, P = 1 - n n'
//   others: κ (f - λ w e) = 0
// Weights are relative to the head's. How far d is along an axis u that turns with a body is u·d, which changes by
// ū·Δd + d̄·Δu, and d̄·Δu = a·(ū x d̄) with the body's Cayley vector a: so besides λ w ū on the points there is a torque
// λ w ū x d̄ on that body, the force of an angular row that turns the axis and has no value of its own.
#include "articulates/solve/couplings.hpp"

#include <algorithm>

#include "articulates/solve/matrix.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// What a row adds to the sum of its coupling: w v, with the weight w relative to the head's.
struct Value {
  Vec3 n;                  // direction of the force
  Vec3 gradient;           // of w v at the end of the step, by d1
  double value;            // w v [m]
  double force_by_lambda;  // [1] w |e|: its force is λ times that, along n
  double turn_of_n;        // by how much n turns with a change of d1, [1/m]
  double displacement;     // [m] of d in the step
};

struct Axis {
  Vec3 at_start, at_end;

  Vec3 mean() const { return (at_start + at_end) * 0.5; }
};
/// That a distance counts along: of a node, or of the world.
Axis axis_of(const Articulate& a, std::int32_t node, const Condition& c) {
  if (node < 0) return {c.axis, c.axis};
  const Node& n = a.nodes[static_cast<std::size_t>(node)];
  return {n.R0 * c.axis, n.R1 * c.axis};
}
bool counts_along_axis(const Row& row, const Condition& c) { return row.lever == 0.0 && norm2(c.axis) > 0.0; }

/// The row of the distance whose axis an angular one turns.
const Row& distance_of(const Articulate& a, const Coupling& coupling, const Condition& c) {
  const auto it = std::find_if(coupling.rows.begin(), coupling.rows.end(), [&](std::uint32_t k) {
    return a.rows[k].lever == 0.0 && condition(a, a.rows[k]).index == c.index;
  });
  return a.rows[*it];
}

/// n·e of an angle: its change φ over what a torque along the mean axis n does work on, n·(a_a - a_b), with the Cayley vectors
/// of both nodes. About one axis these are 2 tan of half their angles, which differ by φ.
double turn_by_work(const Articulate& a, const Row& row, Vec3 n, double turned, double counted) {
  const auto along = [&](std::int32_t node) {
    return node < 0 ? 0.0 : dot(n, a.nodes[static_cast<std::size_t>(node)].cayley);
  };
  const double of_a = along(row.a), of_b = along(row.b), work = of_a - of_b;
  // What is small has the round-off of all turns that were counted; its limit then is off by φ².
  const bool small = std::fabs(turned * turned * turned) < 1e-14 * (1.0 + std::fabs(counted));
  if (!small && std::fabs(work) > 0.1 * std::fabs(turned)) return turned / work;
  const double one_plus_cosine =
      1.0 + dot(direction(row.ra0 + row.ra1), direction(row.rb0 + row.rb1));  // 2 cos² of half the angle
  return std::sqrt(2.0 / std::fmax(one_plus_cosine, 1e-9)) * (1.0 - turned * turned / 12.0) /
         (1.0 + 0.25 * of_a * of_b);
}

Value value_of_angle(const Articulate& a, const Row& row, const Condition& c, double w) {
  const Vec3 n = mean_axis(row);
  const double e = turn_by_work(a, row, n, c.angle1 - c.angle0, c.angle1);
  return {n, angle_gradient(row) * w, c.angle1 * row.lever * w, e * w, 0.0, 0.0};
}

/// Of the angular row that turns the axis of a distance.
Value value_of_turning(const Articulate& a, const Row& row, const Condition& c, const Row& distance, double w) {
  const Axis u = axis_of(a, row.a, c);
  const Vec3 e = cross(u.mean(), distance.d0 + distance.d1) * (0.5 / row.lever);
  return {direction(e), cross(u.at_end, distance.d1) * (w / row.lever), 0.0, norm(e) * w, 0.0, 0.0};
}

Value value(const Articulate& a, const Coupling& coupling, const Row& row, const Condition& c, double w) {
  if (c.turns_axis) return value_of_turning(a, row, c, distance_of(a, coupling, c), w);
  if (row.lever > 0.0) return value_of_angle(a, row, c, w);
  const double displacement = norm(row.d1 - row.d0);
  if (counts_along_axis(row, c)) {
    const Axis u = axis_of(a, row.b, c);
    const Vec3 e = u.mean();
    return {direction(e), u.at_end * w, dot(u.at_end, row.d1) * w, norm(e) * w, 0.0, displacement};
  }
  const double r0 = norm(row.d0), r1 = norm(row.d1), sum = std::fmax(r0 + r1, 1e-300);
  const Vec3 e = (row.d0 + row.d1) / sum;
  const double stretch = std::fmax(norm(e), 1e-3);
  return {direction(e), direction(row.d1) * w, r1 * w, stretch * w, 1.0 / (sum * stretch), displacement};
}

/// [m] at the end of the step.
double value_at_end(const Articulate& a, const Row& row, const Condition& c) {
  if (c.turns_axis) return 0.0;
  if (row.lever > 0.0) return c.angle1 * row.lever;
  return counts_along_axis(row, c) ? dot(axis_of(a, row.b, c).at_end, row.d1) : norm(row.d1);
}

/// The direction of a row's velocities that its value changes with, and by how much.
struct Slope {
  Vec3 n;
  double size;
};
Slope slope(const Articulate& a, const Coupling& coupling, const Row& row, const Condition& c) {
  if (c.turns_axis) {
    const Vec3 gradient = cross(axis_of(a, row.a, c).at_end, distance_of(a, coupling, c).d1) / row.lever;
    return {direction(gradient), norm(gradient)};
  }
  if (row.lever > 0.0) {
    const Vec3 gradient = angle_gradient(row);
    return {direction(gradient), std::fmax(1.0, norm(gradient))};
  }
  return {counts_along_axis(row, c) ? axis_of(a, row.b, c).at_end : direction(row.d1), 1.0};
}

double relative_weight(const Articulate& a, const Coupling& coupling, std::uint32_t k) {
  return condition(a, a.rows[k]).weight / condition(a, a.rows[coupling.head]).weight;
}

/// Σ w v [m of the head].
double sum_of(const Articulate& a, const Coupling& coupling) {
  double sum = 0.0;
  for (std::uint32_t k : coupling.rows) {
    const Row& row = a.rows[k];
    sum += value_at_end(a, row, condition(a, row)) * relative_weight(a, coupling, k);
  }
  return sum;
}

/// By how much a force across what it should be counts [m].
double size_across(const Vec3& across, const Row& row, const Value& v, double kappa) {
  return norm(across) * length_per_force(norm(row.f), v.displacement, kappa);
}

/// Of a row whose coupling is slack: κ f = 0. Returns the size of the residual [m], as do those below.
double let_go(Articulate& a, Row& row, double kappa) {
  Condition& c = condition(a, row);
  c.held = false;
  row.residual = row.f * kappa;
  c.M = c.into_head = c.from_head = zero33();
  c.C = identity33() * kappa;
  return norm(row.residual);
}

/// `over`: by how much the sum is too large [m].
double evaluate_head(Articulate& a, Row& row, const Value& v, double over, double kappa) {
  Condition& c = condition(a, row);
  const Mat3 P = identity33() - outer(v.n, v.n);
  const double along = dot(row.f, v.n);
  const Vec3 across = row.f - v.n * along;
  row.residual = v.n * over + across * kappa;
  c.M = outer(v.n, v.gradient) - P * (kappa * along * v.turn_of_n);
  c.C = P * kappa;
  return std::fmax(std::fabs(over), size_across(across, row, v, kappa));
}

double evaluate_other(Articulate& a, Row& row, const Value& v, const Row& head, const Value& of_head, double kappa) {
  Condition& c = condition(a, row);
  const Vec3 wrong = row.f - v.n * (dot(head.f, of_head.n) / of_head.force_by_lambda * v.force_by_lambda);
  row.residual = wrong * kappa;
  c.M = (identity33() - outer(v.n, v.n)) * (-kappa * dot(row.f, v.n) * v.turn_of_n);
  c.C = identity33() * kappa;
  c.into_head = outer(of_head.n, v.gradient);
  c.from_head = outer(v.n, of_head.n) * (-kappa * v.force_by_lambda / of_head.force_by_lambda);
  return size_across(wrong, row, v, kappa);
}

double evaluate_coupling(Articulate& a, const Coupling& coupling, double h) {
  Row& head = a.rows[coupling.head];
  const Condition& c = condition(a, head);
  const Value of_head = value(a, coupling, head, c, 1.0);
  const double kappa = RowContext{h, mobility(a, head)}.kappa(),
               over = sum_of(a, coupling) - c.kept_value / c.weight - c.accepted;
  const bool held = !c.ranged || dot(head.f, of_head.n) / of_head.force_by_lambda * kappa < over;
  double worst = 0.0;
  for (std::uint32_t k : coupling.rows) {
    Row& row = a.rows[k];
    if (!held) {
      worst = std::fmax(worst, let_go(a, row, kappa));
      continue;
    }
    condition(a, row).held = true;
    const auto own = [&] { return value(a, coupling, row, condition(a, row), relative_weight(a, coupling, k)); };
    worst = std::fmax(worst, k == coupling.head ? evaluate_head(a, row, of_head, over, kappa)
                                                : evaluate_other(a, row, own(), head, of_head, kappa));
  }
  return worst;
}

/// Adds what concerns the rows on one node of one of its rows.
void find_coupled_blocks(const Articulate& a, Coupling& coupling, std::uint32_t own, std::int32_t node) {
  for (std::uint32_t c = 0; c < a.rows.size(); c++) {
    const Row& row = a.rows[c];
    if (row.a != node && row.b != node) continue;
    const bool upper = coupling.head < c;
    const std::uint32_t block =
        c == coupling.head ? c : a.factor.block(std::max(c, coupling.head), std::min(c, coupling.head));
    coupling.blocks.push_back({own, c, static_cast<std::uint32_t>(node), block, upper});
  }
}

}  // namespace

void find_couplings(Articulate& a) {
  for (std::uint32_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (!is_coupled(row)) continue;
    const Condition& c = condition(a, row);
    const auto same = std::find_if(a.couplings.begin(), a.couplings.end(), [&](const Coupling& s) {
      const Condition& head = condition(a, a.rows[s.head]);
      return head.constraint == c.constraint && head.sum == c.sum;
    });
    if (same == a.couplings.end()) {
      a.couplings.push_back({k, {k}, {}, {}, {}});
      continue;
    }
    same->rows.push_back(k);
    // The last: what another row holds still leaves the head no pivot before the others have one.
    if (!condition(a, row).turns_axis) same->head = k;
  }
  for (Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows) {
      if (k == coupling.head) continue;
      for (std::int32_t node : {a.rows[k].a, a.rows[k].b})
        if (node >= 0) find_coupled_blocks(a, coupling, k, node);
      coupling.head_blocks.push_back({k, a.factor.block(std::max(k, coupling.head), std::min(k, coupling.head))});
    }
}

double evaluate_couplings(Articulate& a, double h) {
  double worst = 0.0;
  for (const Coupling& coupling : a.couplings) {
    const double size = evaluate_coupling(a, coupling, h);
    worst = std::isfinite(size) ? std::fmax(worst, size) : infinity;
  }
  return worst;
}

bool leads_to_anchor(const Articulate& a, const Row& row) {
  return is_coupled(row) && row.lever == 0.0 && row.b < 0 && !a.nodes[static_cast<std::size_t>(row.a)].turns &&
         !counts_along_axis(row, condition(a, row));
}

void hold_with_heads(Articulate& a) {
  for (const Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows) condition(a, a.rows[k]).held = condition(a, a.rows[coupling.head]).held;
}

void project_couplings(Articulate& a) {
  for (const Coupling& coupling : a.couplings) {
    const Row& head = a.rows[coupling.head];
    const Condition& of_head = condition(a, head);
    const bool held = of_head.held && !of_head.gives_way;
    const Slope along_head = slope(a, coupling, head, of_head);
    for (std::uint32_t k : coupling.rows) {
      Condition& c = condition(a, a.rows[k]);
      const Slope along = slope(a, coupling, a.rows[k], c);
      const double ratio = c.weight1 * along.size / (of_head.weight1 * along_head.size);
      c.wanted = zero3();
      c.kept = held ? outer(along.n, along.n) : zero33();
      c.into_head = held ? outer(along_head.n, along.n) * ratio : zero33();
      c.from_head = held ? outer(along.n, along_head.n) * -ratio : zero33();
      if (held && k == coupling.head) c.wanted = along.n * (c.value_rate / (c.weight1 * along.size));
    }
  }
}

std::vector<std::pair<std::uint32_t, Vec3>> coupling_gradient(const Articulate& a, const Coupling& coupling) {
  const double of_head = condition(a, a.rows[coupling.head]).weight1;
  std::vector<std::pair<std::uint32_t, Vec3>> gradient;
  for (const std::uint32_t k : coupling.rows) {
    const Condition& c = condition(a, a.rows[k]);
    const Slope along = slope(a, coupling, a.rows[k], c);
    gradient.emplace_back(k, along.n * (along.size * c.weight1 / of_head));
  }
  return gradient;
}

Stop coupling_stop(const Articulate& a, const Row& row) {
  for (const Coupling& coupling : a.couplings) {
    if (&a.rows[coupling.head] != &row) continue;
    const Condition& c = condition(a, row);
    return {slope(a, coupling, row, c).n * -1.0, c.kept_value / c.weight + c.accepted - sum_of(a, coupling)};
  }
  return {zero3()};
}

double motion_per_gap(const Articulate& a, const Row& row) {
  for (const Coupling& coupling : a.couplings) {
    if (&a.rows[coupling.head] != &row) continue;
    double most = 0.0;
    for (std::uint32_t k : coupling.rows) most = std::fmax(most, std::fabs(relative_weight(a, coupling, k)));
    return 1.0 / most;
  }
  return 1.0;
}

Vec3 coupling_gap_of(const Articulate& a, const Row& row) {
  const Stop end = coupling_stop(a, row);
  if (std::isinf(end.room)) return zero3();
  return end.inward * (condition(a, row).ranged ? std::fmin(0.0, end.room) : end.room);
}

}  // namespace pantin
