// A rod: g = (|d1|² - L²)/2L = 0 by a force along the mean direction d̄ = (d0 + d1)/2, so that force times displacement is
// λ Δg exactly (discrete gradient; Gonzalez 1996). The force is a 3-vector like any row's, held to n = d̄/|d̄|. A limit of
// length is the same with two L.
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double above(const Row& row, double length) {
  return std::isinf(length) ? -infinity : (dot(row.d1, row.d1) - length * length) / (2.0 * length);
}

double evaluate_rod(Row& row, Condition& c, const RowContext& context) {
  const Vec3 middle = (row.d0 + row.d1) * 0.5;
  const double mean_length = norm(middle);
  ConstraintFunction r{direction(middle), zero3(), 0.0, 0.0, 0.0, norm(row.d1 - row.d0)};
  const double low = c.ranged ? low_end(c) : c.kept_value, high = c.ranged ? high_end(c) : c.kept_value;
  const double length = (c.ranged ? std::fmin(high, std::fmax(low, norm(row.d1))) : c.kept_value) + c.accepted;
  r.gradient = row.d1 / length;
  r.turn_of_n = 1.0 / (2.0 * std::fmax(mean_length, 1e-3 * length));
  if (c.ranged) {
    r.above_low = low > 0.0 ? above(row, low + c.accepted) : infinity;
    r.above_high = above(row, high + c.accepted);
  } else {
    r.above_low = above(row, length);
  }
  return evaluate_function(row, c, r, context);
}

void project_rod(const Row& row, Condition& c, bool holds) { project_function(c, row.d1, holds); }

Stop stop_of_rod(const Row& row, const Condition& c) {
  const double length = norm(row.d1) - c.accepted;
  return nearer_end(direction(row.d1), c.low > 0.0 ? length - low_end(c) : infinity, length - high_end(c));
}

Vec3 rod_gap(const Row& row, const Condition& c) {
  const double length = norm(row.d1) - c.accepted;
  return direction(row.d1) * (c.ranged ? missing(c, c.low > 0.0 ? length - low_end(c) : infinity, length - high_end(c))
                                       : length - c.kept_value);
}

}  // namespace

const RowRule rod_row = {.evaluate = evaluate_rod, .project = project_rod, .gap = rod_gap, .stop = stop_of_rod};

namespace {

void start(const Model& model, Constraint& c, double tolerance) {
  start_number(c, end_distance(model, c) - c.number.now, end_distance_rate(model, c), tolerance * c.number.now);
}

double gap(const Model& model, const Constraint& c) {
  return std::fabs(end_distance(model, c) - c.number.now - c.attract.excess);
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {between_points(c, rod_row)}; }

}  // namespace

const ConstraintRule rod_rule = {
    .keeps = kept_length,
    .parts_points = true,
    .ends_at_position = true,
    .check = [](const Model& model, Constraint& c) { require_two_ends(model, c, "; a rod ties two"); },
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{1, 1};
        },
    .directions = all_directions,
    .start = start,
    .gap = gap,
    .size = [](const Constraint& c) { return c.number.now; },
    .value = end_distance,
    .rows = rows,
};

}  // namespace pantin
