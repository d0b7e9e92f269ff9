#include "articulates/solve/scalar_rows.hpp"

#include <algorithm>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/wanted_velocities.hpp"

namespace pantin {

namespace {

/// The unit vector n of the projection n n'; 0 of none.
Vec3 axis_of(const Mat3& projection) {
  Vec3 longest = zero3();
  for (int i = 0; i < 3; i++)
    if (norm2(projection[i]) > norm2(longest)) longest = projection[i];
  return direction(longest);
}

ScalarRow row_of(const Articulate& a, const Coupling& coupling) {
  const Row& head = a.rows[coupling.head];
  const Condition& c = condition(a, head);
  ScalarRow s;
  s.wanted = c.value_rate / c.weight1;
  s.lower = -infinity;
  s.upper = infinity;
  double sign = 1.0;
  if (c.ranged) {
    sign = -1.0;
    s.wanted *= -1.0;
    s.lower = 0.0;
    s.room = coupling_stop(a, head).room;
  }
  for (const auto& [k, along] : coupling_gradient(a, coupling)) s.terms.push_back({k, along * sign});
  const auto first = std::find_if(s.terms.begin(), s.terms.end(),
                                  [&](const ScalarRow::Term& term) { return term.row == coupling.head; });
  std::iter_swap(s.terms.begin(), first);
  return s;
}

/// Of a limit or an end of a path, as it would hold.
ScalarRow row_of_stop(const Row& row, Condition c, Stop stop) {
  c.wanted = c.velocity;
  row.rule->project(row, c, true);
  ScalarRow s;
  s.terms.push_back({c.row, stop.inward});
  s.wanted = dot(c.wanted, stop.inward);
  s.room = stop.room;
  s.upper = infinity;
  return s;
}

ScalarRow row_of_motor(const Row& row, Condition c) {
  c.wanted = zero3();
  row.rule->project(row, c, true);
  ScalarRow s;
  s.terms.push_back({c.row, axis_of(c.kept)});
  s.wanted = dot(c.wanted, s.terms.front().along);
  s.upper = c.jam_force > 0.0 ? c.jam_force : c.upper;
  s.lower = -s.upper;
  return s;
}

void add_end(std::vector<ScalarRow::End>& ends, std::int32_t node, Vec3 force, Vec3 moment) {
  if (node < 0) return;
  auto at = std::find_if(ends.begin(), ends.end(), [&](const ScalarRow::End& end) { return end.node == node; });
  if (at == ends.end()) at = ends.insert(at, {node});
  at->force += force;
  at->moment += moment;
}

void find_ends(const Articulate& a, ScalarRow& s) {
  for (const ScalarRow::Term& term : s.terms) {
    const Row& r = a.rows[term.row];
    const auto add = [&](std::int32_t node, Vec3 l, Vec3 along) {
      if (node < 0) return;
      const Mat3& R = a.nodes[static_cast<std::size_t>(node)].R1;
      if (r.lever > 0.0)
        add_end(s.ends, node, zero3(), along * r.lever);
      else
        add_end(s.ends, node, along, cross(R * l, along));
    };
    add(r.a, r.la, term.along);
    add(r.b, r.lb, term.along * -1.0);
  }
}

}  // namespace

std::vector<ScalarRow> scalar_rows(Articulate& a, double step, double wanted_at) {
  const WantedVelocities wanted(a, step, wanted_at);
  std::vector<ScalarRow> all;
  for (const Coupling& coupling : a.couplings) all.push_back(row_of(a, coupling));
  for (const Condition& c : a.conditions) {
    const Row& r = row(a, c);
    if (c.stiff || is_coupled(r) || is_rigid(r) || !is_bounded(c)) continue;
    if (!c.ranged) {
      all.push_back(row_of_motor(r, c));
      continue;
    }
    const Stop end = stop(a, r);
    if (std::isfinite(end.room)) all.push_back(row_of_stop(r, c, end));
  }
  for (ScalarRow& s : all) find_ends(a, s);
  return all;
}

}  // namespace pantin
