// Constraints that guide points: on_plane, on_path, string, and limits of
// length.
#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "forces/sleep.hpp"
#include "model/path.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_point(const World& world, const char* call, PointId point) {
  require(world.points.alive(point), call, ": ", world.points.story(point));
}

Vec3 unit_normal(Vec3 normal) {
  require_finite("on_plane", "normal", normal, "");
  require(norm(normal) > 0.0, "on_plane: normal must not be vec(0, 0, 0)");
  return normal / norm(normal);
}

ConstraintId add_length_limit(World& world, Constraint c, const LimitDef& def) {
  const double min = std::fmax(def.min, 0.0);
  require(def.min >= 0.0 || std::isinf(def.min), "limit: min must be >= 0 m, got ", def.min);
  require(def.max > 0.0 && min < def.max, "limit: min must be below max, got ", min, " and ", def.max, " m");
  require(std::isfinite(def.max) || min > 0.0, "limit: min or max must be given");
  require_positive("limit", "time_constant", def.time_constant, "s");
  c.kind = ConstraintKind::limit;
  c.time_constant = def.time_constant;
  c.low = min;
  c.high = def.max;
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

/// A path at the height of a point, which it had but for round-off.
std::shared_ptr<const Path> level(const World& world, const Path& path, Vec3 point) {
  std::vector<Vec3> positions = path.positions();
  for (Vec3& position : positions) position = world.plane.beside(position, point);
  return std::make_shared<const Path>(std::move(positions), path.smooth(), path.closed());
}

}  // namespace

ConstraintId add_limit(World& world, PointId a, PointId b, const LimitDef& def) {
  require_unlocked(world, "limit");
  require_point(world, "limit", a);
  require_point(world, "limit", b);
  const Point &pa = world.points[a], &pb = world.points[b];
  require(pa.particle != pb.particle, "limit: its ends are one particle, ", describe(world, pa.particle));
  require(!pa.body || pa.body != pb.body, "limit: both ends belong to ", describe(world, pa.body),
          ", which is rigid already");
  Constraint c;
  c.a = a;
  c.b = b;
  return add_length_limit(world, std::move(c), def);
}

ConstraintId add_limit(World& world, PointId a, Vec3 position, const LimitDef& def) {
  require_unlocked(world, "limit");
  require_point(world, "limit", a);
  require_finite("limit", "position", position, "m");
  Constraint c;
  c.a = a;
  c.position.now = position;
  return add_length_limit(world, std::move(c), def);
}

ConstraintId add_on_plane(World& world, PointId point, const PlaneDef& def) {
  require_unlocked(world, "on_plane");
  require_point(world, "on_plane", point);
  if (def.through) require_finite("on_plane", "through", *def.through, "m");
  require_positive("on_plane", "time_constant", def.time_constant, "s");
  Constraint c;
  c.kind = ConstraintKind::on_plane;
  c.a = point;
  c.time_constant = def.time_constant;
  c.position.now = def.through.value_or(position(world, point));
  c.axis_a = unit_normal(def.normal);
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

ConstraintId add_string(World& world, std::vector<Passage> passages, const StringDef& def) {
  require_unlocked(world, "string");
  require(passages.size() >= 2, "string: needs two points or more, got ", passages.size());
  require_positive("string", "time_constant", def.time_constant, "s");
  Constraint c;
  double fixed = 0.0;
  for (std::size_t i = 0; i < passages.size(); i++) {
    const Passage& p = passages[i];
    if (p.point) require_point(world, "string", p.point);
    if (!p.point) require_finite("string", "a position", p.position, "m");
    if (p.point && !c.a) c.a = p.point;
    for (std::size_t j = 0; j < i && p.point; j++)
      require(!passages[j].point || world.points[passages[j].point].particle != world.points[p.point].particle,
              "string: points ", j + 1, " and ", i + 1, " are one particle");
    if (i > 0 && !p.point && !passages[i - 1].point) fixed += norm(p.position - passages[i - 1].position);
  }
  require(static_cast<bool>(c.a), "string: it goes through positions only; one must be a point or a particle");
  c.kind = ConstraintKind::string;
  c.time_constant = def.time_constant;
  c.own = StringData{std::move(passages)};
  c.number.now = def.length.value_or(present_value(world, c));
  require_positive("string", "length", c.number.now, "m");
  require(c.number.now > fixed, "string: its positions are ", fixed, " m apart, so it cannot be ", c.number.now,
          " m long");
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

ConstraintId add_on_path(World& world, PointId point, std::shared_ptr<const Path> path, double time_constant) {
  require_unlocked(world, "on_path");
  require_point(world, "on_path", point);
  require_positive("on_path", "time_constant", time_constant, "s");
  Constraint c;
  c.kind = ConstraintKind::on_path;
  c.a = point;
  c.time_constant = time_constant;
  c.own = PathData{std::move(path)};
  require_in_plane(world, c);
  if (world.plane.flat()) c.as<PathData>().path = level(world, *c.as<PathData>().path, position(world, point));
  start_constraint(world, c);
  return insert_constraint(world, std::move(c));
}

void set_normal(World& world, ConstraintId id, Vec3 normal) {
  require_unlocked(world, "normal");
  Constraint& c = world.constraints[id];
  require(c.kind == ConstraintKind::on_plane, "normal: ", describe(world, id), " has none");
  require_in_plane(world, "on_plane", "normal", unit_normal(normal), "");
  wake(world, c);
  c.axis_a = unit_normal(normal);
  start_constraint(world, c);
}

}  // namespace pantin
