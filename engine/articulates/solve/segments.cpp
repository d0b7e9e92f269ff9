// The gradient of a segment's length |d| that makes force times displacement exact is e = (d0 + d1)/(|d0| + |d1|), so
// the forces are λ e with one λ <= 0 for all segments: what the string gives on one side it takes on the other, without
// work.
//   head:   n (Σ |d1| - L) + κ P f = 0, or f = 0 where the string is slack;   n
//   = e/|e|, P = 1 - n n' others: κ (f - λ e) = 0
#include "articulates/solve/segments.hpp"

#include <algorithm>

#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

struct Segment {
  Vec3 n;               // direction of the force
  Vec3 gradient;        // of the length at the end of the step
  double stretch;       // |e|
  double bend;          // by how much n turns with a change of d1, [1/m]
  double displacement;  // [m] of d in the step
};

Segment segment(const Row& row) {
  const double r0 = norm(row.d0), r1 = norm(row.d1), sum = std::fmax(r0 + r1, 1e-300);
  const Vec3 e = (row.d0 + row.d1) / sum;
  const double stretch = std::fmax(norm(e), 1e-3);
  return {direction(e), direction(row.d1), stretch, 1.0 / (sum * stretch), norm(row.d1 - row.d0)};
}

double total_length(const Articulate& a, const SlidingString& string) {
  double sum = 0.0;
  for (std::uint32_t k : string.segments) sum += norm(a.rows[k].d1);
  return sum;
}

double weighted(const Vec3& across, const Row& row, const Segment& s, double kappa) {
  return norm(across) * std::fmax(kappa, s.displacement / std::fmax(norm(row.f), 1e-3 * s.displacement / kappa));
}

double let_go(Articulate& a, Row& row, double kappa) {
  Condition& c = condition(a, row);
  c.held = false;
  row.residual = row.f * kappa;
  c.M = c.into_head = c.from_head = zero33();
  c.C = identity33() * kappa;
  return norm(row.residual);
}

double evaluate_head(Articulate& a, Row& row, const Segment& s, double over, double kappa) {
  Condition& c = condition(a, row);
  const Mat3 P = identity33() - outer(s.n, s.n);
  const double along = dot(row.f, s.n);
  const Vec3 across = row.f - s.n * along;
  row.residual = s.n * over + across * kappa;
  c.M = outer(s.n, s.gradient) - P * (kappa * along * s.bend);
  c.C = P * kappa;
  return std::fmax(std::fabs(over), weighted(across, row, s, kappa));
}

double evaluate_other(Articulate& a, Row& row, const Segment& s, const Row& head, const Segment& of_head,
                      double kappa) {
  Condition& c = condition(a, row);
  const Vec3 wrong = row.f - s.n * (dot(head.f, of_head.n) / of_head.stretch * s.stretch);
  row.residual = wrong * kappa;
  c.M = (identity33() - outer(s.n, s.n)) * (-kappa * dot(row.f, s.n) * s.bend);
  c.C = identity33() * kappa;
  c.into_head = outer(of_head.n, s.gradient);
  c.from_head = outer(s.n, of_head.n) * (-kappa * s.stretch / of_head.stretch);
  return weighted(wrong, row, s, kappa);
}

double evaluate_string(Articulate& a, const SlidingString& string, double h) {
  Row& head = a.rows[string.head];
  const Segment of_head = segment(head);
  const double kappa = 0.5 * h * h * mobility(a, head);
  const Condition& c = condition(a, head);
  const double over = total_length(a, string) - c.length - c.accepted;
  const bool held = dot(head.f, of_head.n) / of_head.stretch * kappa < over;
  double worst = 0.0;
  for (std::uint32_t k : string.segments) {
    Row& row = a.rows[k];
    if (!held) {
      worst = std::fmax(worst, let_go(a, row, kappa));
      continue;
    }
    condition(a, row).held = true;
    worst = std::fmax(worst, k == string.head ? evaluate_head(a, row, of_head, over, kappa)
                                              : evaluate_other(a, row, segment(row), head, of_head, kappa));
  }
  return worst;
}

/// Adds what concerns the rows on one node of a segment.
void find_string_blocks(const Articulate& a, SlidingString& string, std::uint32_t segment, std::int32_t node) {
  for (std::uint32_t c = 0; c < a.rows.size(); c++) {
    const Row& row = a.rows[c];
    if (row.a != node && row.b != node) continue;
    const bool upper = string.head < c;
    const std::uint32_t block =
        c == string.head ? c : a.factor.block(std::max(c, string.head), std::min(c, string.head));
    string.blocks.push_back({segment, c, static_cast<std::uint32_t>(node), block, upper});
  }
}

}  // namespace

void find_strings(Articulate& a) {
  for (std::uint32_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    if (row.kind != RowKind::segment) continue;
    const ConstraintId id = condition(a, row).constraint;
    const auto same = std::find_if(a.strings.begin(), a.strings.end(), [&](const SlidingString& s) {
      return condition(a, a.rows[s.head]).constraint == id;
    });
    if (same == a.strings.end()) {
      a.strings.push_back({k, {k}, {}, {}, {}});
      continue;
    }
    same->segments.push_back(k);
    same->head =
        k;  // the last: what another row holds still leaves the head no pivot before the other segments have one
  }
  for (SlidingString& string : a.strings)
    for (std::uint32_t k : string.segments) {
      if (k == string.head) continue;
      for (std::int32_t node : {a.rows[k].a, a.rows[k].b})
        if (node >= 0) find_string_blocks(a, string, k, node);
      string.links.push_back({k, a.factor.block(std::max(k, string.head), std::min(k, string.head))});
    }
}

double evaluate_strings(Articulate& a, double h) {
  double worst = 0.0;
  for (const SlidingString& string : a.strings) {
    const double size = evaluate_string(a, string, h);
    worst = std::isfinite(size) ? std::fmax(worst, size) : infinity;
  }
  return worst;
}

void hold_with_heads(Articulate& a) {
  for (const SlidingString& string : a.strings)
    for (std::uint32_t k : string.segments) condition(a, a.rows[k]).held = condition(a, a.rows[string.head]).held;
}

void project_strings(Articulate& a) {
  for (const SlidingString& string : a.strings) {
    const bool held = condition(a, a.rows[string.head]).held;
    const Vec3 along_head = direction(a.rows[string.head].d1);
    for (std::uint32_t k : string.segments) {
      const Vec3 n = direction(a.rows[k].d1);
      Condition& c = condition(a, a.rows[k]);
      c.wanted = zero3();
      c.kept = held ? outer(n, n) : zero33();
      c.into_head = held ? outer(along_head, n) : zero33();
      c.from_head = held ? outer(n, along_head) * -1.0 : zero33();
      if (held && k == string.head) c.wanted = n * c.length_rate;
    }
  }
}

Stop string_stop(const Articulate& a, const Row& row) {
  for (const SlidingString& string : a.strings) {
    if (&a.rows[string.head] != &row) continue;
    const Condition& c = condition(a, row);
    return {direction(row.d1) * -1.0, c.length + c.accepted - total_length(a, string)};
  }
  return {zero3()};
}

Vec3 string_gap(const Articulate& a, const Row& row) {
  const Stop end = string_stop(a, row);
  return end.inward * std::fmin(0.0, end.room);
}

}  // namespace pantin
