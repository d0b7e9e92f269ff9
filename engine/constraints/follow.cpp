// A follow with a limit: a damped spring taken at the end of the step (backward, dissipative), whose pull saturates:
//   z = (k + d_c/h) d1 - (d_c/h) d0,   f = -z min(1, F/|z|).
#include "base/check_values.hpp"
#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_soft(Row& row, Condition& c, const RowContext& context) {
  const double k = c.stiffness + c.damping / context.h;
  const Vec3 z = row.d1 * k - row.d0 * (c.damping / context.h);
  const double pull = norm(z);
  c.C = identity33();
  if (pull <= c.max_force) {
    row.residual = row.f + z;
    c.M = c.C * k;
    return norm(row.residual) / k;
  }
  const Vec3 u = z / pull;
  const double secant = k * c.max_force / pull;
  row.residual = row.f + u * c.max_force;
  c.M = (c.C - outer(u, u)) * secant;
  return norm(row.residual) / secant;
}

/// By the start of the step, softened as a backward step would.
Vec3 soft_pull(const Row& row, const Condition& c, const RowContext& context) {
  const double give = 1.0 + context.h * (context.h * c.stiffness + c.damping) * context.mobility;
  const Vec3 z = row.d0 * (-c.stiffness / give);
  const double pull = norm(z);
  return pull > c.max_force ? z * (c.max_force / pull) : z;
}

void project_soft(const Row&, Condition& c, bool) { c.kept = zero33(); }

}  // namespace

const RowRule soft_row = {
    .soft = true, .at_distance = true, .evaluate = evaluate_soft, .project = project_soft, .pull = soft_pull};

namespace {

/// Whether it holds its point as a nail does.
bool is_rigid(const Constraint& c) { return !std::isfinite(c.max_force); }

void check(const Model&, Constraint& c) {
  internal::require_positive_or_infinite("follow", "max_force", c.max_force, "N");
  internal::require_finite("follow", "target", c.position.now, "m");
}

void start(const Model& model, Constraint& c, double tolerance) {
  if (is_rigid(c)) start_point(model, c, from_position(model, c), velocity(model, c.a), tolerance);
}

double gap(const Model& model, const Constraint& c) {
  return is_rigid(c) ? norm(from_position(model, c) - c.attract.away) : 0.0;
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) {
  return {between_points(c, is_rigid(c) ? rigid_row : soft_row)};
}

}  // namespace

const ConstraintRule follow_rule = {
    .joins_points = true,
    .ends_at_position = true,
    .check = check,
    .freedoms =
        [](const Constraint& c) {
          return is_rigid(c) ? FreedomsTaken{3, 2} : FreedomsTaken{};
        },
    .pins = [](const Constraint& c) { return is_rigid(c) ? "held by a follow without max_force" : nullptr; },
    .directions = all_directions,
    .start = start,
    .gap = gap,
    .rows = rows,
};

}  // namespace pantin
