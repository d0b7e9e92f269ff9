// Contacts of solid points, with shapes and with each other.
#include <algorithm>

#include "contacts/bodies.hpp"
#include "contacts/crowd.hpp"
#include "contacts/find_parts.hpp"

namespace pantin {

namespace {

/// Calls use(side) with one of the solid points.
template <class Use>
void with_point(const Model& model, const ContactFinder& finder, std::size_t i, Use use) {
  const SolidPoint& point = finder.solids[i];
  const std::uint32_t thing = point_thing(point.slot);
  const Geometry ball = BallShape{point.radius};
  ShapeNow at;
  at.reach = point.radius;
  at.thickness = 2.0 * point.radius;
  at.pose.x = finder.points_now[i].x;
  use(ContactSide{thing, static_cast<std::int32_t>(thing), ball, at, finder.going[number_of(model, thing)],
                  point.touch.friction, point.touch.restitution, 0.0, 0.0, zero3(), false});
}

void points_on_shapes(const ThingsNow& p, const ContactFinder& finder, FoundContacts& found) {
  for (std::size_t i = 0; i < finder.solids.size(); i++) {
    const SolidPoint& point = finder.solids[i];
    const PointNow& at = finder.points_now[i];
    finder.broad_phase.in_box(widened({at.x, at.x}, point.radius + at.margin), [&](std::uint32_t slot) {
      const Shape& shape = p.model.shapes.at_slot(slot);
      const ShapeNow& now = finder.shapes_now[slot];
      const LayerRule* rule = p.model.layers.rule(point.touch.layer, shape.layer);
      if ((rule && !rule->collide) || !(at.moves || now.moves)) return;
      if (shape.body && are_tied(finder, point_thing(point.slot), shape.body.slot - 1)) return;
      with_point(p.model, finder, i, [&](const ContactSide& a) {
        add_contacts(p, a, side_of(p.model, finder, slot), rule, at.margin + now.margin, found);
      });
      require_no_crowd(found.list.size(), finder.solids.size() + finder.shapes_now.size(), {at.x, at.x});
    });
  }
}

void points_on_points(const ThingsNow& p, ContactFinder& finder, FoundContacts& found) {
  std::vector<std::uint32_t> index(p.model.points.slots());
  for (std::uint32_t i = 0; i < finder.solids.size(); i++) {
    const SolidPoint& point = finder.solids[i];
    if (!point.among_others) continue;
    const PointNow& at = finder.points_now[i];
    index[point.slot] = i;
    Bounds bounds;
    bounds.add(at.x);
    bounds.add(at.x + at.displacement);
    finder.points.put({widened(bounds, point.radius + at.still), point.slot, at.moves}, 0.2 * point.radius);
  }
  for (const auto& pair : finder.points.pairs()) {
    const std::uint32_t i = index[pair.first], j = index[pair.second];
    const SolidPoint &x = finder.solids[i], &y = finder.solids[j];
    PointNow &at_x = finder.points_now[i], &at_y = finder.points_now[j];
    const double nearing = norm(at_x.displacement - at_y.displacement);
    const double margin = at_x.still + at_y.still + nearing, reach = x.radius + y.radius + margin;
    if (norm2(at_x.x - at_y.x) > reach * reach) continue;
    const LayerRule* rule = p.model.layers.rule(x.touch.layer, y.touch.layer);
    if ((rule && !rule->collide) || are_tied(finder, point_thing(x.slot), point_thing(y.slot))) continue;
    for (PointNow* pushed : {&at_x, &at_y})  // one may push the other on to what it would not have met
      pushed->margin = std::max(pushed->margin, pushed->still + norm(pushed->displacement) + nearing);
    with_point(p.model, finder, i, [&](const ContactSide& a) {
      with_point(p.model, finder, j, [&](const ContactSide& b) { add_contacts(p, a, b, rule, margin, found); });
    });
  }
}

}  // namespace

void locate_points(const ThingsNow& p, ContactFinder& finder) {
  finder.points_now.clear();
  for (const SolidPoint& point : finder.solids) {
    const std::uint32_t thing = point_thing(point.slot);
    const BodyState s = state_of(p.model, p.articulates, thing, p.drifted);
    const bool falls = p.drifted && !is_loose_point(p.model, thing);
    finder.going[number_of(p.model, thing)] = {falls ? s.v - p.gravity * (0.5 * p.drift) : s.v, zero3(), s.mass};
    const double rest = still_margin * 2.0 * point.radius + norm(p.gravity) * p.h * p.h;
    finder.points_now.push_back(
        {s.x, s.v * p.h, rest, rest + norm(s.v) * p.h, !asleep(p.model, p.articulates, p.contacts, thing)});
  }
}

void find_of_points(const ThingsNow& p, ContactFinder& finder, FoundContacts& found) {
  const auto first = static_cast<std::ptrdiff_t>(found.list.size()),
             first_sensed = static_cast<std::ptrdiff_t>(found.sensed.size());
  points_on_points(p, finder, found);
  points_on_shapes(p, finder, found);
  std::sort(found.list.begin() + first, found.list.end(), by_key);
  std::sort(found.sensed.begin() + first_sensed, found.sensed.end(), by_key);
}

}  // namespace pantin
