#pragma once
// The matrix of the rows, filled and factorised.
#include "articulates/articulate.hpp"

namespace pantin {

/// Where in the step the row forces act: at the arms of its start (Euler), the mean of both ends (the
/// midpoint step), or its end (projections).
enum class Arms : std::uint8_t { start, mean, end };
/// The rows' matrix and right side: left arms at the end, right arms as told, M and C of the rows (`times_C` C is added: 2/h² in
/// Newton's matrix, 1/h² with `euler`, in projections the largest mobility of a row, since C has no unit there),
/// compliance `epsilon` relative to the diagonal. Nodes turn by R I⁻¹ R' of the start or end, or, with arms at the mean of
/// a step of `h`, as Newton's matrix says. The right side is `times_residual` times the residual, with Newton's matrix also
/// what the nodes' own residuals move.
struct System {
  Arms right;
  double epsilon, times_C, times_residual, h = 0.0;
  bool may_turn = true;  ///< the nodes; else they are only shifted
};
/// Fills and factorises the matrix and takes its right side through the forward substitution, which ends with
/// `Factor::substitute_back`. Returns whether a pivot is weak.
bool factorise(Articulate& articulate, const System& system);
/// Before the forward substitution of a right side.
void clear_hubs(Articulate& articulate);
/// Between that and the backward substitution.
void solve_hubs(Articulate& articulate);
/// As `factorise` for another right side, on the factor of Newton's matrix at hand.
void reuse_factor(Articulate& articulate, const System& system);

/// tr(S_kk)/3 of a row from the nodes' masses and inverse inertia, of a turn along its axes, [1/kg].
double mobility(const Articulate& articulate, const Row& row);

}  // namespace pantin
