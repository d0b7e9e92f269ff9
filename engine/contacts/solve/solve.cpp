#include "contacts/solve/solve.hpp"

#include <algorithm>
#include <cmath>

#include "contacts/solve/search.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t most_of_newton = 15;
constexpr double accepted = 100.0;  // of the tolerance

/// What may stay open while things move fast [m/s]: nothing that is seen.
double loosely(const ContactIsland& island) {
  double fastest = 0.0;
  for (const IslandBody& b : island.bodies) fastest = std::fmax(fastest, norm2(b.v0));
  const double tight = accepted * island.tolerance;
  return std::clamp(0.02 * std::sqrt(fastest), tight, 1e4 * tight);
}

/// Puts impulses into the cone.
void confine(ContactIsland& island) {
  for (IslandContact& c : island.contacts) {
    if (!c.on || !(c.impulse[0] > 0.0)) {
      c.impulse = zero3();
      continue;
    }
    const double t = std::sqrt(c.impulse[1] * c.impulse[1] + c.impulse[2] * c.impulse[2]),
                 bound = c.friction * c.impulse[0];
    if (t <= bound) continue;
    c.impulse[1] *= bound / t;
    c.impulse[2] *= bound / t;
  }
}

}  // namespace

IslandReport solve_island(ContactIsland& island) {
  prepare(island);
  const double tight = accepted * island.tolerance;
  SearchReport found = newton_search(island, most_of_newton);
  IslandReport report{found.residual, found.iterations, found.factorisations, true};
  if (!(found.residual <= tight)) {
    report.by_newton = false;
    confine(island);
    if (std::isfinite(found.residual))
      for (IslandContact& c : island.contacts) c.start = c.impulse;
    if (std::isfinite(found.residual))
      for (IslandTie& t : island.ties) t.start = t.impulse;
    const SearchReport near = proximal_search(island, loosely(island));
    report.residual = near.residual;
    report.iterations += near.iterations;
    report.factorisations += near.factorisations;
    if (near.residual > tight && near.residual <= 1e4 * tight) {
      const SearchReport polished = newton_search(island, most_of_newton);
      report.residual = std::fmin(near.residual, polished.residual);
      report.iterations += polished.iterations;
      report.factorisations += polished.factorisations;
    }
  }
  confine(island);
  apply_impulses(island);
  return report;
}

}  // namespace pantin
