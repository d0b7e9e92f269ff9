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

ShapeNow locate(const ThingsNow& p, const ContactFinder& finder, const Shape& shape) {
  ShapeNow now;
  now.thickness = thickness_of(shape.geometry);
  now.reach = reach_of(shape.geometry);
  now.margin = margin_at_rest(now);
  if (!shape.body) {
    now.pose = {shape.at, matrix(shape.orientation)};
    return now;
  }
  const std::uint32_t slot = shape.body.slot - 1;
  const BodyState s = state_of(p.model, p.articulates, slot, p.drifted);
  now.moves = !sleeps_in_touch(p.contacts, slot);
  now.pose = Pose{s.x, s.R} * in_principal_axes(p.model.bodies[shape.body], shape);
  now.arm = now.pose.x - s.x;
  now.going.mass = s.mass;
  if (!now.moves) return now;
  now.going = {p.drifted ? s.v - p.gravity * (0.5 * p.drift) : s.v, s.w, s.mass};
  const double arm = norm(now.arm) + now.reach;
  now.margin += finder.ahead * p.h * (norm(s.v) + norm(s.w) * arm + norm(p.gravity) * p.h);
  return now;
}

void put(const Model& m, ContactFinder& finder, std::uint32_t s) {
  const Shape& shape = m.shapes.at_slot(s);
  const ShapeNow& now = finder.shapes_now[s];
  const double slack = now.moves ? now.margin + 0.1 * now.thickness : 0.0;
  const std::uint32_t owner = shape.body ? shape.body.slot : BoundsTree::none;
  finder.broad_phase.put({widened(bounds_of(shape.geometry, now.pose), now.margin), s, now.moves, owner}, slack);
}

/// All shapes; `find(slot)` says where one is.
template <class Find>
void put_all(const Model& m, ContactFinder& finder, std::uint64_t sleep_changes, Find find) {
  for (std::size_t s = m.shapes.slots(); s < finder.serials.size(); s++)
    finder.broad_phase.remove(static_cast<std::uint32_t>(s));
  finder.shapes_now.resize(m.shapes.slots());
  finder.serials.resize(m.shapes.slots(), 0);
  finder.going.assign(m.bodies.slots() + (m.solids ? m.points.slots() : 0), Going{});
  finder.height_fields.clear();
  finder.moving.clear();
  for (std::uint32_t s = 0; s < m.shapes.slots(); s++) {
    const bool alive = m.shapes.alive_at(s);
    if (finder.serials[s] != 0 && (!alive || finder.serials[s] != m.shapes.at_slot(s).serial))
      finder.broad_phase.remove(s);
    finder.serials[s] = alive ? m.shapes.at_slot(s).serial : 0;
    if (!alive) continue;
    const Shape& shape = m.shapes.at_slot(s);
    if (std::holds_alternative<std::shared_ptr<const HeightField>>(shape.geometry)) finder.height_fields.push_back(s);
    finder.shapes_now[s] = find(s);
    put(m, finder, s);
    if (finder.shapes_now[s].moves) finder.moving.push_back(s);
    if (shape.body) finder.going[shape.body.slot - 1] = finder.shapes_now[s].going;
  }
  finder.changed = false;
  finder.sleep_changes = sleep_changes;
}

}  // namespace

Pose pose_of(const Model& m, const Shape& shape) {
  if (!shape.body) return {shape.at, matrix(shape.orientation)};
  const Motion& motion = m.motion_of(shape.body);
  return Pose{motion.x, matrix(motion.q)} * in_principal_axes(m.bodies[shape.body], shape);
}

void put_bounds(const ThingsNow& p, ContactFinder& finder) {
  const auto find = [&](std::uint32_t s) { return locate(p, finder, p.model.shapes.at_slot(s)); };
  finder.displaced = false;
  if (finder.changed || finder.sleep_changes != p.contacts.sleep_changes)
    return put_all(p.model, finder, p.contacts.sleep_changes, find);
  for (const std::uint32_t s : finder.moving) {
    finder.shapes_now[s] = find(s);
    put(p.model, finder, s);
  }
}

void keep_shapes(const ContactFinder* finder, const Model& model, ShapesThen& kept) {
  kept.known = finder && !finder->changed && !finder->asked_changed && !model.places_changed;
  if (!kept.known) return;
  kept.shapes = finder->shapes_now;
  kept.going = finder->going;
  kept.rebounding = finder->rebounding;
  kept.ahead = finder->ahead;
  kept.sleep_changes = finder->sleep_changes;
  kept.displaced = finder->displaced || finder->asked_displaced;
}

void put_back(std::unique_ptr<ContactFinder>& finder, Model& model, const ShapesThen& then) {
  if (!then.known) {
    finder.reset();
    return;
  }
  model.places_changed = true;
  renew(finder, model);
  put_all(model, *finder, then.sleep_changes, [&](std::uint32_t s) { return then.shapes[s]; });
  finder->going = then.going;
  finder->rebounding = then.rebounding;
  finder->ahead = then.ahead;
  finder->displaced = then.displaced;
  finder->asked_changed = finder->asked_displaced = false;
}

}  // namespace pantin
