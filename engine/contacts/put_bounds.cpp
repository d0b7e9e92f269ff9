// Where shapes are, and how far they may get.
#include <cmath>

#include "contacts/bodies.hpp"
#include "contacts/find_parts.hpp"

namespace pantin {

namespace {

Pose in_principal_axes(const Body& body, const Shape& shape) {
  const Quat to_axes = conjugate(body.axes);
  return {rotate(to_axes, shape.at - body.centre), matrix(to_axes * shape.orientation)};
}

Placed place(const Placement& p, const Shape& shape) {
  Placed placed;
  placed.thickness = thickness_of(shape.geometry);
  placed.reach = reach_of(shape.geometry);
  if (std::isfinite(placed.thickness)) placed.margin = still_margin * placed.thickness;
  if (!shape.body) {
    placed.pose = {shape.at, matrix(shape.orientation)};
    return placed;
  }
  const std::uint32_t slot = shape.body.slot - 1;
  const BodyState s = state_of(p.model, p.articulates, slot, p.drifted);
  placed.moves = !sleeps_in_touch(p.contacts, slot);
  placed.pose = Pose{s.x, s.R} * in_principal_axes(p.model.bodies[shape.body], shape);
  placed.arm = placed.pose.x - s.x;
  placed.going.mass = s.mass;
  if (!placed.moves) return placed;
  placed.going = {p.drifted ? s.v - p.gravity * (0.5 * p.drift) : s.v, s.w, s.mass};
  const double arm = norm(placed.arm) + placed.reach;
  placed.margin += p.h * (norm(s.v) + norm(s.w) * arm + norm(p.gravity) * p.h);
  return placed;
}

void put(const Placement& p, ContactFinder& finder, std::uint32_t s) {
  const Shape& shape = p.model.shapes.at_slot(s);
  const Placed& placed = finder.placed[s] = place(p, shape);
  const double slack = placed.moves ? placed.margin + 0.1 * placed.thickness : 0.0;
  const std::uint32_t owner = shape.body ? shape.body.slot : BoundsTree::none;
  finder.broad_phase.put({widened(bounds_of(shape.geometry, placed.pose), placed.margin), s, placed.moves, owner},
                         slack);
}

void put_all(const Placement& p, ContactFinder& finder) {
  const Store<Shape>& shapes = p.model.shapes;
  finder.placed.resize(shapes.slots());
  finder.serials.resize(shapes.slots(), 0);
  finder.going.assign(p.model.bodies.slots() + (p.model.solids ? p.model.points.slots() : 0), Going{});
  finder.height_fields.clear();
  finder.moving.clear();
  for (std::uint32_t s = 0; s < shapes.slots(); s++) {
    const bool alive = shapes.alive_at(s);
    if (finder.serials[s] != 0 && (!alive || finder.serials[s] != shapes.at_slot(s).serial))
      finder.broad_phase.remove(s);
    finder.serials[s] = alive ? shapes.at_slot(s).serial : 0;
    if (!alive) continue;
    const Shape& shape = shapes.at_slot(s);
    if (std::holds_alternative<std::shared_ptr<const HeightField>>(shape.geometry)) finder.height_fields.push_back(s);
    put(p, finder, s);
    if (finder.placed[s].moves) finder.moving.push_back(s);
    if (shape.body) finder.going[shape.body.slot - 1] = finder.placed[s].going;
  }
  finder.changed = false;
  finder.sleep_changes = p.contacts.sleep_changes;
}

}  // namespace

Pose pose_of(const Model& m, const Shape& shape) {
  if (!shape.body) return {shape.at, matrix(shape.orientation)};
  const Motion& motion = m.motion_of(shape.body);
  return Pose{motion.x, matrix(motion.q)} * in_principal_axes(m.bodies[shape.body], shape);
}

void put_bounds(const Placement& p, ContactFinder& finder) {
  finder.displaced = false;
  if (finder.changed || finder.sleep_changes != p.contacts.sleep_changes) return put_all(p, finder);
  for (const std::uint32_t s : finder.moving) put(p, finder, s);
}

}  // namespace pantin
