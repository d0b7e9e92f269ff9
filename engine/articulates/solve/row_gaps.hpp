#pragma once
// Rows of an articulate at the end of a step: what they miss.
#include "articulates/articulate.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

/// Sets the residual of a row at the end of a step of h [s], with its M and C; returns its size [m].
double residual(Articulate& articulate, Row& row, double h);

/// The nearer end of the range of a row, at the end of the step.
Stop stop(const Articulate& articulate, const Row& row);
/// What is still to be closed of a row at the end of the step, [m].
Vec3 gap(const Articulate& articulate, const Row& row);
/// Takes the present gap of a row as a constant offset.
void accept_gap(Articulate& articulate, Row& row);

}  // namespace pantin
