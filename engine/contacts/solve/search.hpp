#pragma once
// The two searches for the impulses of an island.
#include "contacts/solve/island.hpp"
#include "contacts/solve/matrix.hpp"

namespace pantin {

struct SearchReport {
  double residual = infinity;  ///< [m/s] of the impulses and velocities that are left
  std::uint32_t iterations = 0, factorisations = 0;
};

/// Newton's iteration on a smoothed form of Coulomb's law, primal and dual at once, from the impulses at hand; what it found
/// best is left. Quadratic near a solution; far from one, or for large ratios of mass, it may stall.
SearchReport newton_search(ContactIsland& island, std::uint32_t most_iterations);
/// Proximal point iteration from IslandContact::start: convex problems, each solved by Newton with an exact line search, in
/// which normal speeds are raised by friction |u_t| of the last (De Saxcé 1992; Acary and Cadoux 2013): that makes the
/// associated cone Coulomb's law. Always comes nearer; slow for the last digits.
SearchReport proximal_search(ContactIsland& island, double wanted);

/// The loads that impulses do not yet balance: Σ J' impulses - M (v - v0).
void unbalanced(const ContactIsland& island, std::vector<BodyLoad>& load);

}  // namespace pantin
