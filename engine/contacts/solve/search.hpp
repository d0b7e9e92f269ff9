#pragma once
// The three searches for the impulses of an island.
#include "contacts/solve/island.hpp"
#include "contacts/solve/matrix.hpp"

namespace pantin {

struct SearchReport {
  double residual = infinity;  ///< [m/s] of the impulses and velocities that are left
  std::uint32_t iterations = 0, factorisations = 0;
};

/// A search stalls where its residual did not halve in more than `most` iterations, one after the other.
struct Patience {
  std::uint32_t most;
  double mark;  ///< [m/s] the residual when it last halved
  std::uint32_t waited = 0;

  bool ends(double residual) {
    if (residual < 0.5 * mark) {
      mark = residual;
      waited = 0;
    } else {
      waited++;
    }
    return waited > most;
  }
};

/// Newton's iteration on a smoothed form of Coulomb's law, primal and dual at once, from the impulses at hand; what it found
/// best is left. The factor is laid out for all. Quadratic near a solution; far from one, or for large ratios of mass, it may stall.
SearchReport newton_search(ContactIsland& island, std::uint32_t most_iterations);
/// Rounds of convex problems, from the impulses at hand, to 0.02 of the fastest body's speed, at most 100 times
/// `enough` [m/s], or the tolerance if that is more; what it found best is left. The factor is laid out for all. Dear, but each round has an end, wherever it begins.
SearchReport proximal_search(ContactIsland& island, std::uint32_t most_rounds);
/// So many sweeps over the contacts, or `most_of_all` while one changes more than 1e3 `enough`, up and down, one by one, with all ties at
/// once after each; ends where a sweep changes velocities at contacts by no more than `enough` [m/s]. Never far from the law, and quick; slow for what carries far.
SearchReport sweep_search(ContactIsland& island, std::uint32_t most_sweeps, double enough,
                          std::uint32_t most_of_all = 0);

/// The loads that impulses do not yet balance: Σ J' impulses - M (v - v0).
void unbalanced(const ContactIsland& island, std::vector<BodyLoad>& load);

}  // namespace pantin
