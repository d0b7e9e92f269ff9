// Several values add up to one, Σ w v = L: lengths of a string's segments, turns of gears, heights of racks. What makes
// force times displacement exact for a value is its discrete gradient e: of a length (d0 + d1)/(|d0| + |d1|), of a height
// its direction, of an angle that turns by φ the axis n times φ/(n·(ā_a - ā_b)), for that is what a torque does work on. So the
// forces are λ w e with one λ for all: what the coupling gives on one side it takes on the other, without work.
//   head:   n (Σ w v - L) + κ P f = 0, or f = 0 where it is one-sided and slack;   n = e/|e|, P = 1 - n n'
//   others: κ (f - λ w e) = 0
// Weights are relative to the head's. A distance that has sides is s |d|, with s kept from step to step; in the step in which
// it changes, e = (n0 + n1)/(1 + n0·n1) of the directions n = s d/|d|, which is exact too.
#include "articulates/solve/couplings.hpp"

#include <algorithm>

#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

struct Value {
  Vec3 n;               // direction of the force
  Vec3 gradient;        // of w v at the end of the step, by d1
  double value;         // w v [m]
  double share;         // w |e|
  double bend;          // by how much n turns with a change of d1, [1/m]
  double displacement;  // [m] of d in the step
};

/// Of a distance at the ends of a step.
struct Distance {
  Vec3 n0, n1;           // unit vectors in which it grows
  double value;          // [m] at the end
  double side = 1.0;     // there
  bool crosses = false;  // from one side to the other, or too near to its point at an end to have a direction there
};

/// Kept from step to step: a distance that turns round its point stays on its side, one that passes it along the axis changes.
Distance distance(const Articulate& a, const Row& row, const Condition& c) {
  const double r0 = norm(row.d0), r1 = norm(row.d1), least = 1e-9 * a.length;
  if (c.angle0 == 0.0) return {direction(row.d0), direction(row.d1), r1};
  const Node& n = a.nodes[static_cast<std::size_t>(row.b)];
  const Vec3 u0 = n.R0 * c.axis, u1 = n.R1 * c.axis;
  const double along = dot(u1, row.d1);
  if (r1 <= least) return {r0 > least ? direction(row.d0) * c.angle0 : u0, u1, along, along < 0.0 ? -1.0 : 1.0, true};
  const bool passes = along * c.angle0 < -0.9 * r1 && norm(row.d1 - row.d0) > r1;
  const double side = passes ? -c.angle0 : c.angle0;
  return {r0 > least ? direction(row.d0) * c.angle0 : u0, direction(row.d1) * side, side * r1, side,
          passes || r0 <= least};
}

/// By how much more an angle turns than a torque along the mean axis n does work on: φ/(n·(ā_a - ā_b)), with the Cayley vectors
/// of both ends. About one axis these are 2 tan(α/2) and 2 tan(β/2), α - β = φ.
double turn_by_work(const Articulate& a, const Row& row, Vec3 n, double turned) {
  const auto along = [&](std::int32_t node) {
    return node < 0 ? 0.0 : dot(n, a.nodes[static_cast<std::size_t>(node)].a);
  };
  const double of_a = along(row.a), of_b = along(row.b), work = of_a - of_b;
  if (std::fabs(turned) > 1e-4 && std::fabs(work) > 0.1 * std::fabs(turned)) return turned / work;
  return (1.0 - turned * turned / 12.0) / (1.0 + 0.25 * of_a * of_b);
}

Value value(const Articulate& a, const Row& row, const Condition& c, double w) {
  if (row.lever > 0.0)
    return {mean_axis(row),
            twist_gradient(row) * w,
            c.angle1 * row.lever * w,
            turn_by_work(a, row, mean_axis(row), c.angle1 - c.angle0) * w,
            0.0,
            0.0};
  const double displacement = norm(row.d1 - row.d0);
  if (norm2(c.direction) > 0.0)
    return {c.direction, c.direction * w, dot(c.direction, row.d1) * w, w, 0.0, displacement};
  const Distance d = distance(a, row, c);
  if (d.crosses) {
    const Vec3 e = (d.n0 + d.n1) / (1.0 + dot(d.n0, d.n1));
    return {direction(e), d.n1 * w, d.value * w, norm(e) * w, 0.0, displacement};
  }
  const double sum = std::fmax(norm(row.d0) + norm(row.d1), 1e-300);
  const Vec3 e = (row.d0 + row.d1) / (d.side * sum);
  const double stretch = std::fmax(norm(e), 1e-3);
  return {direction(e), d.n1 * w, d.value * w, stretch * w, d.side / (sum * stretch), displacement};
}

/// [m] at the end of the step.
double value_at_end(const Articulate& a, const Row& row, const Condition& c) {
  if (row.lever > 0.0) return c.angle1 * row.lever;
  return norm2(c.direction) > 0.0 ? dot(c.direction, row.d1) : distance(a, row, c).value;
}

/// The direction of a row's velocities that its value changes with, and by how much.
struct Slope {
  Vec3 n;
  double size;
};
Slope slope(const Articulate& a, const Row& row, const Condition& c) {
  if (row.lever > 0.0) {
    const Vec3 gradient = twist_gradient(row);
    return {direction(gradient), std::fmax(1.0, norm(gradient))};
  }
  return {norm2(c.direction) > 0.0 ? c.direction : distance(a, row, c).n1, 1.0};
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

double weighted(const Vec3& across, const Row& row, const Value& v, double kappa) {
  return norm(across) * std::fmax(kappa, v.displacement / std::fmax(norm(row.f), 1e-3 * v.displacement / kappa));
}

double let_go(Articulate& a, Row& row, double kappa) {
  Condition& c = condition(a, row);
  c.held = false;
  row.residual = row.f * kappa;
  c.M = c.into_head = c.from_head = zero33();
  c.C = identity33() * kappa;
  return norm(row.residual);
}

double evaluate_head(Articulate& a, Row& row, const Value& v, double over, double kappa) {
  Condition& c = condition(a, row);
  const Mat3 P = identity33() - outer(v.n, v.n);
  const double along = dot(row.f, v.n);
  const Vec3 across = row.f - v.n * along;
  row.residual = v.n * over + across * kappa;
  c.M = outer(v.n, v.gradient) - P * (kappa * along * v.bend);
  c.C = P * kappa;
  return std::fmax(std::fabs(over), weighted(across, row, v, kappa));
}

double evaluate_other(Articulate& a, Row& row, const Value& v, const Row& head, const Value& of_head, double kappa) {
  Condition& c = condition(a, row);
  const Vec3 wrong = row.f - v.n * (dot(head.f, of_head.n) / of_head.share * v.share);
  row.residual = wrong * kappa;
  c.M = (identity33() - outer(v.n, v.n)) * (-kappa * dot(row.f, v.n) * v.bend);
  c.C = identity33() * kappa;
  c.into_head = outer(of_head.n, v.gradient);
  c.from_head = outer(v.n, of_head.n) * (-kappa * v.share / of_head.share);
  return weighted(wrong, row, v, kappa);
}

void find_sides(Articulate& a, const Coupling& coupling) {
  for (std::uint32_t k : coupling.rows) {
    const Row& row = a.rows[k];
    Condition& c = condition(a, row);
    if (row.lever == 0.0 && c.angle0 != 0.0) c.angle1 = distance(a, row, c).side;
  }
}

double evaluate_coupling(Articulate& a, const Coupling& coupling, double h) {
  Row& head = a.rows[coupling.head];
  const Condition& c = condition(a, head);
  find_sides(a, coupling);
  const Value of_head = value(a, head, c, 1.0);
  const double kappa = 0.5 * h * h * mobility(a, head), over = sum_of(a, coupling) - c.length / c.weight - c.accepted;
  const bool held = !c.ranged || dot(head.f, of_head.n) / of_head.share * kappa < over;
  double worst = 0.0;
  for (std::uint32_t k : coupling.rows) {
    Row& row = a.rows[k];
    if (!held) {
      worst = std::fmax(worst, let_go(a, row, kappa));
      continue;
    }
    condition(a, row).held = true;
    const auto own = [&] { return value(a, row, condition(a, row), relative_weight(a, coupling, k)); };
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
    if (row.kind != RowKind::coupled) continue;
    const ConstraintId id = condition(a, row).constraint;
    const auto same = std::find_if(a.couplings.begin(), a.couplings.end(),
                                   [&](const Coupling& s) { return condition(a, a.rows[s.head]).constraint == id; });
    if (same == a.couplings.end()) {
      a.couplings.push_back({k, {k}, {}, {}, {}});
      continue;
    }
    same->rows.push_back(k);
    same->head = k;  // the last: what another row holds still leaves the head no pivot before the others have one
  }
  for (Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows) {
      if (k == coupling.head) continue;
      for (std::int32_t node : {a.rows[k].a, a.rows[k].b})
        if (node >= 0) find_coupled_blocks(a, coupling, k, node);
      coupling.links.push_back({k, a.factor.block(std::max(k, coupling.head), std::min(k, coupling.head))});
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

void hold_with_heads(Articulate& a) {
  for (const Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows) condition(a, a.rows[k]).held = condition(a, a.rows[coupling.head]).held;
}

void project_couplings(Articulate& a) {
  for (const Coupling& coupling : a.couplings) {
    const Row& head = a.rows[coupling.head];
    const Condition& of_head = condition(a, head);
    const bool held = of_head.held;
    find_sides(a, coupling);
    const Slope along_head = slope(a, head, of_head);
    for (std::uint32_t k : coupling.rows) {
      Condition& c = condition(a, a.rows[k]);
      const Slope along = slope(a, a.rows[k], c);
      const double share = c.weight1 * along.size / (of_head.weight1 * along_head.size);
      c.wanted = zero3();
      c.kept = held ? outer(along.n, along.n) : zero33();
      c.into_head = held ? outer(along_head.n, along.n) * share : zero33();
      c.from_head = held ? outer(along.n, along_head.n) * -share : zero33();
      if (held && k == coupling.head) c.wanted = along.n * (c.length_rate / (c.weight1 * along.size));
    }
  }
}

Stop coupling_stop(const Articulate& a, const Row& row) {
  for (const Coupling& coupling : a.couplings) {
    if (&a.rows[coupling.head] != &row) continue;
    const Condition& c = condition(a, row);
    return {slope(a, row, c).n * -1.0, c.length / c.weight + c.accepted - sum_of(a, coupling)};
  }
  return {zero3()};
}

double told_by_head(const Articulate& a, const Row& row) {
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
