#pragma once
// What each kind of row asks for. A kind is one file that fills one entry of the table: the residual of the row at the
// end of a step with its derivative, and its part in the velocity projection.
#include "articulates/articulate.hpp"

namespace pantin {

struct RowContext {
  double h;         ///< [s]
  double mobility;  ///< [1/kg] tr(S_kk)/3 of the row, last known: how far a force moves it
};

struct RowRule {
  /// Sets residual, M and C from d0, d1 and f; returns the size of the residual in metres.
  double (*evaluate)(Row& row, Condition& condition, const RowContext& context);
  /// Sets M and C for the projection of velocities, so that M (S μ) + C μ = -M (velocity of d1).
  void (*project)(const Row& row, Condition& condition);
};

/// (kinds)
extern const RowRule row_rules[3];

double evaluate_limited(Row& row, Condition& condition, const RowContext& context);
void project_limited(const Row& row, Condition& condition);
double evaluate_rod(Row& row, Condition& condition, const RowContext& context);
void project_rod(const Row& row, Condition& condition);

inline const RowRule& rule(const Row& row) { return row_rules[static_cast<std::size_t>(row.kind)]; }

/// Sets the residual of a row at the end of a step of h [s], with its M and C; returns its size [m].
double residual(Articulate& articulate, Row& row, double h);

}  // namespace pantin
