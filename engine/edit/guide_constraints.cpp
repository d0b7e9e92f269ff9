// Constraints that guide points: on_path, string, and limits of length.
#include "constraints/kind.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "model/path.hpp"

namespace pantin {

using namespace internal;

namespace {

/// A path at the height of a point, which it had but for round-off.
std::shared_ptr<const Path> level(const World& world, const Path& path, Vec3 point) {
  std::vector<Vec3> positions = path.positions();
  for (Vec3& position : positions) position = world.plane.beside(position, point);
  return std::make_shared<const Path>(std::move(positions), path.smooth(), path.closed());
}

ConstraintId add_length_limit(World& world, Constraint c, const LimitDef& def) {
  c.kind = ConstraintKind::limit;
  c.time_constant = def.time_constant;
  c.low = def.min;
  c.high = def.max;
  return add_constraint(world, std::move(c));
}

}  // namespace

ConstraintId add_limit(World& world, PointId a, PointId b, const LimitDef& def) {
  require_point(world, "limit", b);
  Constraint c;
  c.a = a;
  c.b = b;
  return add_length_limit(world, std::move(c), def);
}

ConstraintId add_limit(World& world, PointId a, Vec3 position, const LimitDef& def) {
  Constraint c;
  c.a = a;
  c.position.now = position;
  return add_length_limit(world, std::move(c), def);
}

ConstraintId add_string(World& world, std::vector<Passage> passages, const StringDef& def) {
  Constraint c;
  c.kind = ConstraintKind::string;
  c.time_constant = def.time_constant;
  for (const Passage& p : passages) {
    if (!p.point) continue;
    require_point(world, "string", p.point);
    if (!c.a) c.a = p.point;
  }
  c.own = StringData{std::move(passages)};
  c.number.now = def.length.value_or(present_value(world, c));
  return add_constraint(world, std::move(c));
}

ConstraintId add_on_path(World& world, PointId point, std::shared_ptr<const Path> path, double time_constant) {
  Constraint c;
  c.kind = ConstraintKind::on_path;
  c.a = point;
  c.time_constant = time_constant;
  c.own = PathData{path};
  check_constraint(world, c);
  if (world.plane.flat()) c.own = PathData{level(world, *path, position(world, point))};
  return add_constraint(world, std::move(c));
}

}  // namespace pantin
