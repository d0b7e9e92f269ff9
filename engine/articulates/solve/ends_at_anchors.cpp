#include "articulates/solve/ends_at_anchors.hpp"

#include <utility>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/node_batches.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

void EndsAtAnchors::take(double h) {
  const double near = 1e-12 * a_.length;
  for (const Coupling& coupling : a_.couplings)
    for (const std::uint32_t k : coupling.rows) {
      const Row& row = a_.rows[k];
      if (!leads_to_anchor(a_, row) || !condition(a_, row).held_before) continue;
      Node& n = node_of(k);
      const double away = norm(row.d0);
      if (away > 2.0 * near && dot(row.d0, row.d0 + n.p0 * (n.inverse_mass * h)) > 0.0) continue;
      met_ = met_ || away > 1e-9 * a_.length;
      ends_.push_back({k, n.inverse_mass});
      n.x0 -= direction(row.d0) * (away - near);
      set_end_from_start(n);
    }
  if (!ends_.empty()) place_rows_at_start(a_);
}

void EndsAtAnchors::fix() {
  for (const End& e : ends_) set_inverse_mass(e.row, 0.0);
}

bool EndsAtAnchors::let_go() {
  std::vector<End> stay;
  for (const End& e : ends_) {
    const Vec3 by_string = a_.impulses[e.row], rest = node_of(e.row).p0 - by_string;
    if (norm(rest) <= norm(by_string)) {
      stay.push_back(e);
      continue;
    }
    Node& n = node_of(e.row);
    set_inverse_mass(e.row, e.inverse_mass);
    n.p0 = rest;
    n.x0 += direction(rest) * (1e-9 * a_.length) - a_.rows[e.row].d0;
    set_end_from_start(n);
  }
  const bool some = stay.size() < ends_.size();
  ends_ = std::move(stay);
  return some;
}

void EndsAtAnchors::rest() {
  for (const End& e : ends_) node_of(e.row).p0 = zero3();
}

void EndsAtAnchors::release() {
  rest();
  for (const End& e : ends_) set_inverse_mass(e.row, e.inverse_mass);
}

void EndsAtAnchors::set_inverse_mass(std::uint32_t row, double inverse_mass) {
  const auto i = static_cast<std::size_t>(a_.rows[row].a);
  a_.nodes[i].inverse_mass = inverse_mass;
  a_.batches[i / batch_size].inverse_mass[i % batch_size] = inverse_mass;
}

}  // namespace pantin
