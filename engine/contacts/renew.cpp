// What edits change of who may touch.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/stable.hpp"
#include "contacts/find.hpp"

namespace pantin {

namespace {

/// Of a point that is no body's: its thing where it is solid.
std::optional<std::uint32_t> thing_of(const Model& m, PointId id) {
  const Point& point = m.points[id];
  if (point.body) return point.body.slot - 1;
  return solid_of(m, point) ? std::optional(point_thing(id.slot - 1)) : std::nullopt;
}

/// Things that do not collide: bodies that a hinge, a weld or a slider ties or a join draws together, points in a hinge or a
/// join, points that a rod ties.
std::vector<std::pair<std::uint32_t, std::uint32_t>> tied_things(const Model& m) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto add = [&](PointId i, PointId j) {
    const auto a = thing_of(m, i), b = thing_of(m, j);
    if (a && b && a != b) pairs.push_back(std::minmax(*a, *b));
  };
  for (const ParticleId id : m.particles.ids()) {
    const Particle& ring = m.particles[id];
    if (!ring.joins()) continue;
    for (std::size_t i = 0; i < ring.points.size(); i++)
      for (std::size_t j = 0; j < i; j++) {
        const bool of_bodies = m.points[ring.points[i]].body && m.points[ring.points[j]].body;
        if (!(ring.collide && of_bodies)) add(ring.points[i], ring.points[j]);
      }
  }
  for (const ConstraintId id : m.constraints.ids()) {
    const Constraint& c = m.constraints[id];
    if (!c.enabled) continue;
    if (c.is<WeldData>() && c.body_a && c.body_b && c.body_a != c.body_b)
      pairs.push_back(std::minmax(c.body_a.slot - 1, c.body_b.slot - 1));
    if (c.kind == ConstraintKind::join) add(c.a, c.b);
    if (m.solids && c.kind == ConstraintKind::rod && c.b && !m.points[c.a].body && !m.points[c.b].body) add(c.a, c.b);
    if (c.kind != ConstraintKind::slider) continue;
    const auto a = thing_of(m, c.a);
    if (const BodyId carrier = c.coupled()[0].body_b; a && carrier) pairs.push_back(std::minmax(*a, carrier.slot - 1));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<HingedPair> hinged_pairs(const Model& m) {
  std::vector<HingedPair> pairs;
  for (const ParticleId id : m.particles.ids()) {
    const Particle& ring = m.particles[id];
    if (!ring.joins() || !ring.collide) continue;
    Vec3 axis = zero3();
    if (!ring.axes.empty()) {
      const Constraint& c = m.constraints[ring.axes[0]];
      axis = rotate(orientation(m, c.body_a), c.axis_a);
    }
    for (const PointId i : ring.points)
      for (const PointId j : ring.points) {
        const BodyId a = m.points[i].body, b = m.points[j].body;
        if (a && b && a.slot < b.slot)
          pairs.push_back({a.slot - 1, b.slot - 1, arm(m, i), rotate(conjugate(m.motion_of(a).q), axis)});
      }
  }
  sort_stably(pairs.begin(), pairs.end(),
              [](const HingedPair& x, const HingedPair& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  return pairs;
}

/// (slots of families) Whether those of a solid family may touch others, or themselves.
std::vector<char> which_touch_others(const Model& m) {
  std::vector<char> which(m.families.slots(), 0);
  for (const FamilyId a : m.families.ids())
    for (const FamilyId b : m.families.ids()) {
      const std::optional<Solid>&x = m.families[a].solid, &y = m.families[b].solid;
      if (!x || !y) continue;
      const LayerRule* rule = m.layers.rule(x->layer, y->layer);
      which[a.slot - 1] |= !rule || rule->collide;
    }
  return which;
}

/// By slot.
std::vector<SolidPoint> solid_points(const Model& m) {
  std::vector<SolidPoint> list;
  if (!m.solids) return list;
  const std::vector<char> touch_others = which_touch_others(m);
  for (std::uint32_t slot = 0; slot < m.points.slots(); slot++) {
    if (!m.points.alive_at(slot)) continue;
    const Point& point = m.points.at_slot(slot);
    const Solid* solid = solid_of(m, point);
    if (!solid) continue;
    const double radius = radius_of(m, point);
    const bool among_others = touch_others[m.particles[point.particle].family.slot - 1] != 0;
    if (radius > 0.0) list.push_back({slot, radius, *solid, among_others});
  }
  return list;
}

bool among_others(const std::vector<SolidPoint>& list, std::uint32_t slot) {
  const auto found =
      std::lower_bound(list.begin(), list.end(), slot,
                       [](const SolidPoint& point, std::uint32_t wanted) { return point.slot < wanted; });
  return found != list.end() && found->slot == slot && found->among_others;
}

}  // namespace

bool renew(std::unique_ptr<ContactFinder>& finder, Model& model) {
  const bool changed = !finder || model.places_changed;
  if (!finder) finder = std::make_unique<ContactFinder>();
  model.places_changed = false;
  if (!changed) return false;
  finder->changed = true;
  finder->ahead = 1.0;
  finder->tied = tied_things(model);
  finder->hinged = hinged_pairs(model);
  const std::vector<SolidPoint> before = std::exchange(finder->solids, solid_points(model));
  for (const SolidPoint& point : before)
    if (point.among_others && !among_others(finder->solids, point.slot)) finder->points.remove(point.slot);
  return true;
}

}  // namespace pantin
