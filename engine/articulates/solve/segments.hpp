#pragma once
// A string: segments between points that it slides through, as one constraint on the sum of their lengths. Each segment
// is a row with a force of its own; one of them, the head, has the equation of the length, the others that their
// tension is the head's.
#include "articulates/solve/newton.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

/// Finds the segments of each string, and what of the matrix its head adds up. Call once rows are in order.
void find_strings(Articulate& articulate);

/// Sets residual, M and C of all segments at the end of a step of h [s]; returns the largest residual [m].
double evaluate_strings(Articulate& articulate, double h);
/// Sets `kept` and `wanted` of the segments, and what couples them in the projection.
void project_strings(Articulate& articulate);
/// Has all segments hold that have heads which do.
void hold_with_heads(Articulate& articulate);
/// What keeps a head from making its string longer than it may be.
Stop string_stop(const Articulate& articulate, const Row& row);
/// How much longer the strings are than they may be: of a head, along itself; else 0, [m].
Vec3 string_gap(const Articulate& articulate, const Row& row);

/// What the other segments add to the head's equation by their velocities `v(row)`, or other changes of d1.
template <class Change>
Vec3 into_head(const Articulate& a, const SlidingString& string, Change change) {
  Vec3 sum = zero3();
  for (std::uint32_t k : string.segments)
    if (k != string.head) sum += condition(a, a.rows[k]).into_head * change(a.rows[k]);
  return sum;
}

}  // namespace pantin
