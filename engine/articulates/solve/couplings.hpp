#pragma once
// Couplings: rows whose values, times weights, add up to one number. Each has a force of its own; one of them, the head,
// has the equation of the sum, the others that their force is as the head's.
#include <utility>
#include <vector>

#include "articulates/articulate.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

/// Finds the rows of each coupling, and what of the matrix its head adds up. Call once rows are in order.
void find_couplings(Articulate& articulate);

/// Sets residual, M and C of all coupled rows at the end of a step of h [s]; returns the largest residual [m].
double evaluate_couplings(Articulate& articulate, double h);
/// Sets `kept` and `wanted` of coupled rows, and what couples them in the projection.
void project_couplings(Articulate& articulate);
/// Has all rows hold that have heads which do.
/// Whether a row is the length of a string from a point mass to an anchor: at 0 it has no direction.
bool leads_to_anchor(const Articulate& articulate, const Row& row);
void hold_with_heads(Articulate& articulate);
/// What keeps a head from making its sum larger than it may be.
Stop coupling_stop(const Articulate& articulate, const Row& row);
/// By how much its sum, in metres of the head, changes with the velocities of each of its rows.
std::vector<std::pair<std::uint32_t, Vec3>> coupling_gradient(const Articulate& articulate, const Coupling& coupling);
/// 1 / max |weight| over a head's rows [1]: times the head's gap it is how far the nearest thing would have to move.
double motion_per_gap(const Articulate& articulate, const Row& row);
/// By how much the sum is wrong: of a head, along itself; else 0, [m].
Vec3 coupling_gap_of(const Articulate& articulate, const Row& row);

/// What the other rows add to the head's equation by their velocities `v(row)`, or other changes of d1.
template <class Change>
Vec3 into_head(const Articulate& a, const Coupling& coupling, Change change) {
  Vec3 sum = zero3();
  for (std::uint32_t k : coupling.rows)
    if (k != coupling.head) sum += condition(a, a.rows[k]).into_head * change(a.rows[k]);
  return sum;
}

}  // namespace pantin
