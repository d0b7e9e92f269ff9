// Damped rows that were solved settle, by impulses that are solved with those of all that forbids velocities.
#include "articulates/solve/settle.hpp"

#include <algorithm>

#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/state.hpp"

namespace pantin {

namespace {

/// Work of what settles [J], by its impulses and its residuals before.
double work_of_settling(const Articulate& a) {
  double work = 0.0;
  for (const Condition& c : a.conditions) {
    if (!c.settles) continue;
    const Vec3 impulse = a.impulses[c.row], before = row(a, c).residual, after = impulse / -c.settling;
    work += dot(impulse, c.wanted + (before + after) * 0.5);
  }
  return work;
}

}  // namespace

bool is_to_settle(const Articulate& a) {
  return a.nonconservative && !a.fell_back && !a.touches &&
         std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) { return c.settling > 0.0; });
}

void settle_velocities(Articulate& a, DriftReport& report) {
  for (Condition& c : a.conditions) c.settles = c.settling > 0.0;
  drop_factor(a, FactorOf::projection);
  begin_answers(a, 0.0);
  for (std::size_t b = 0; b < a.batches.size(); b++) read_momenta(a, b);
  report.tell(answer(a));
  report.damped += work_of_settling(a);
  for (std::size_t b = 0; b < a.batches.size(); b++) tell_momenta(a, b);
  for (Condition& c : a.conditions) c.settles = false;
  drop_factor(a, FactorOf::projection);
  if (a.sums_impulses) add_impulses_exerted(a);
}

}  // namespace pantin
