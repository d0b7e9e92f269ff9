// A point on a path c(u): d = y - c(u) at the nearest u, which has two dimensions. The force has none along the chord
// c(u1) - c(u0), the very displacement, so that it does no work: n the direction of the chord,
//   y1 - c(u1) + κ n (n·f) = 0.
// At the end of an open path the point is held there, as long as it would go on: where it is, and where its force would
// move it to (Alart and Curnier 1991), tell, so that round-off of the position does not.
#include <algorithm>
#include <cmath>
#include <limits>

#include "constraints/geometry.hpp"
#include "constraints/plans.hpp"
#include "model/path.hpp"

#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

struct PathEnd {
  Vec3 position = zero3(), out = zero3();  // [m]; unit vector
  double room = infinity;                  // [m] to it; below 0 where it is passed
};

/// The end of the piece of an open path that a point d is on, at parameter u; no direction where the piece has none.
PathEnd end_near(const Path& path, PathRun run, double along, Vec3 d) {
  const double u = std::fmin(std::fmax(along, run.from), run.to);
  const bool first = u < 1.0 && u <= 0.5 * path.pieces(), last = u > path.pieces() - 1.0;
  if (path.closed() || !(first || last)) return {};
  const double at = first ? 0.0 : path.pieces();
  const Vec3 position = path.position(at), out = path.tangent(at) * (first ? -1.0 : 1.0);
  const bool passed = first ? u <= at : u >= at;
  return {position, out, passed ? -dot(d - position, out) : norm(path.position(u) - position)};
}

double evaluate_path(Row& row, Condition& c, const RowContext& context) {
  const Path& path = *c.path;
  const double kappa = context.kappa();
  const auto hold = [&](Vec3 at) {
    row.residual = row.d1 - at - row.offset;
    c.M = identity33();
    c.C = zero33();
    return norm(row.residual);
  };
  if (c.run.is_corner()) {
    c.angle1 = c.run.to;
    return hold(path.position(c.run.to));
  }
  c.angle1 = path.nearest(row.d1, c.angle0, c.run);
  const Vec3 position = path.position(c.angle1, c.run), open = row.d1 - position;
  const PathEnd end = end_near(path, c.run, c.angle1, row.d1);
  c.held = -dot(row.f, end.out) * kappa > end.room;
  if (c.held) return hold(end.position);
  const Vec3 chord = position - path.position(c.angle0, c.run), T = path.tangent(c.angle1, c.run);
  const double displacement = norm(chord);
  const bool turns = displacement > 1e-12 * norm(position) && !path.is_straight(c.angle0, c.angle1, c.run);
  const Vec3 n = turns ? chord / displacement : T;
  const double along = dot(row.f, n);
  row.residual = open - row.offset + n * (along * kappa);
  const double turned = turns ? dot(row.f, T - n * dot(n, T)) / displacement : 0.0;
  c.M = identity33() - outer(T, T) + outer(n, T) * (kappa * turned);
  c.C = outer(n, n) * kappa;
  // Of a force along it that positions have no digits for, what it moves is all that counts.
  const double unknown = 4.0 * std::numeric_limits<double>::epsilon() * norm(row.d1) / kappa, wrong = std::fabs(along);
  const double as_long = length_per_force(norm(row.f), displacement, kappa);
  return std::max({norm(open - row.offset), wrong * kappa, (wrong - unknown) * as_long});
}

void project_path(const Row& row, Condition& c, bool holds) {
  if (!c.run.is_corner()) c.angle1 = c.path->nearest(row.d1, c.angle1, c.run);
  const Vec3 T = norm2(c.turning) > 0.0 ? c.turning : c.path->tangent(c.angle1, c.run);
  c.kept = holds || c.run.is_corner() ? identity33() : identity33() - outer(T, T);
}

Stop stop_of_path(const Row& row, const Condition& c) {
  const PathEnd end = end_near(*c.path, c.run, c.angle1, row.d1);
  return {end.out * -1.0, end.room};
}

Vec3 path_gap(const Row& row, const Condition& c) {
  const double u = c.run.is_corner() ? c.run.to : c.path->nearest(row.d1, c.angle1, c.run);
  return row.d1 - c.path->position(u, c.run) - row.offset;
}

}  // namespace

const RowRule path_row = {.held_at_end = true,
                          .guides = true,
                          .offsets_gap = true,
                          .evaluate = evaluate_path,
                          .project = project_path,
                          .gap = path_gap,
                          .stop = stop_of_path};

namespace {

const Path& path_of(const Constraint& c) { return *c.as<PathData>().path; }

void start(const Model& model, Constraint& c, double tolerance) {
  const Vec3 at = position(model, c.a);
  const double along = path_of(c).nearest(at);
  c.as<PathData>().along = along;
  c.as<PathData>().run = {};
  const Vec3 T = path_of(c).tangent(along), off = at - path_of(c).position(along), v = velocity(model, c.a);
  if (norm(off) <= tolerance * std::fmax(size_of(model, c.a), largest(at))) return;
  c.attract.away = off;
  c.attract.away_rate = v - T * dot(T, v);
}

double gap(const Model& model, const Constraint& c) {
  const Vec3 at = position(model, c.a) - c.attract.away;
  return norm(at - path_of(c).position(path_of(c).nearest(at, c.as<PathData>().along)));
}

std::vector<RowPlan> rows(const Model&, const Constraint& c) { return {between_points(c, path_row)}; }

void load(Condition& condition, const Row&, const Model& model, const Constraint& c) {
  condition.path = &path_of(c);
  condition.extent = path_of(c).extent();
  condition.angle0 = condition.angle1 = c.as<PathData>().along;
  const PathRun last = c.as<PathData>().run;
  condition.run =
      last.has(condition.angle0) ? last : path_of(c).run(condition.angle0, model.plane.along(velocity(model, c.a)));
  const Vec3 at = path_of(c).positions()[0], height = at - model.plane.along(at);
  condition.whole0 -= height;
  condition.whole1 -= height;
}

}  // namespace

const ConstraintRule on_path_rule = {
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{2, 1};
        },
    .directions = [](const Constraint& c) { return all_across(path_of(c).tangent(c.as<PathData>().along)); },
    .start = start,
    .gap = gap,
    .size = [](const Constraint& c) { return norm(path_of(c).positions()[1] - path_of(c).positions()[0]); },
    .rows = rows,
    .load = load,
    .has_range = [](const Constraint& c) { return !path_of(c).closed(); },
};

}  // namespace pantin
