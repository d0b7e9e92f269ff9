// A limit: a distance or an angle stays between two, by the row of a rod or of a motor with a range.
#include "base/check.hpp"
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"

namespace pantin {

namespace {

void check(const Model& model, Constraint& c) {
  if (!c.a) return internal::require_range("limit", c.low, c.high, "rad");
  require_two_ends(model, c);
  require(c.low >= 0.0 || std::isinf(c.low), "limit: min must be >= 0 m, got ", c.low);
  c.low = std::fmax(c.low, 0.0);
  require(c.high > 0.0 && c.low < c.high, "limit: min must be below max, got ", c.low, " and ", c.high, " m");
  require(std::isfinite(c.high) || c.low > 0.0, "limit: min or max must be given");
}

/// How far a value is outside the range.
double outside(const Constraint& c, double value) {
  return std::fmax(0.0, value - c.high) + std::fmin(0.0, value - c.low);
}

double value(const Model& model, const Constraint& c) { return c.a ? end_distance(model, c) : c.angle; }

double rate(const Model& model, const Constraint& c) {
  if (c.a) return end_distance_rate(model, c);
  return dot(direction_of(model, c.body_a, c.axis_a), relative_spin(model, c));
}

void start(const Model& model, Constraint& c, double tolerance) {
  if (!c.a) count_anew(model, c);
  const double now = value(model, c);
  start_number(c, outside(c, now), rate(model, c), tolerance * (c.a ? now : 1.0));
}

double gap(const Model& model, const Constraint& c) {
  const double past = std::fabs(outside(c, value(model, c))) - std::fabs(c.attract.excess);
  return std::fmax(0.0, c.a ? past : past * lever(model, c));
}

/// Of a distance the end that is not open.
double size(const Constraint& c) { return !c.a ? 0.0 : std::isfinite(c.high) ? c.high : c.low; }

std::vector<RowPlan> rows(const Model&, const Constraint& c) {
  return {c.a ? between_points(c, rod_row) : angular_row(c, turn_row)};
}

void load(Condition& condition, const Row& row, const Model&, const Constraint& c) {
  if (!is_drawn_in(c)) return;
  const double end = (c.a ? 1.0 : row.lever) * (c.attract.first_excess > 0.0 ? c.high : c.low);
  condition.whole_value0 += end;
  condition.whole_value1 += end;
}

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  if (c.a) return {};
  return {{"axis", direction_of(model, c.body_a, c.axis_a), true}};
}

}  // namespace

const ConstraintRule limit_rule = {
    .ends_at_position = true,
    .check = check,
    .freedoms = [](const Constraint&) { return FreedomsTaken{}; },
    .directions = no_direction,
    .start = start,
    .gap = gap,
    .size = size,
    .value = value,
    .rows = rows,
    .load = load,
    .has_range = [](const Constraint&) { return true; },
    .in_plane = in_plane,
};

}  // namespace pantin
