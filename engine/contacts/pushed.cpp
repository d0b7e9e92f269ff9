#include "contacts/pushed.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "contacts/bodies.hpp"
#include "contacts/find_parts.hpp"
#include "contacts/hidden.hpp"
#include "shapes/ray.hpp"

namespace pantin {

namespace {

/// Looks along the ways of bodies that are pushed.
class Search {
 public:
  Search(const ThingsNow& p, ContactFinder& finder, const Contacts& contacts)
      : p_(p), finder_(finder), contacts_(contacts) {}

  /// A body that goes on so from now; what it meets does, too.
  void push(std::uint32_t body, Vec3 v, Vec3 w) {
    Going& going = finder_.going[body];
    if (!before_.emplace(body, going).second) return;
    going.v = v;
    going.w = w;
    waiting_.push_back(body);
  }
  /// Adds what they meet, and forgets that they were pushed. Nothing where that is more than is worth it, as in an explosion.
  void run(FoundContacts& found) {
    const std::size_t most = contacts_.list.size() + most_for_each * finder_.shapes_now.size();
    for (std::size_t i = 0; i < waiting_.size() && found.list.size() <= most; i++)
      for (const ShapeId id : p_.model.bodies.at_slot(waiting_[i]).shapes) look_along(id.slot - 1, found);
    for (const auto& [body, going] : before_) finder_.going[body] = going;
    if (found.list.size() > most) found.list.clear();
  }

 private:
  static constexpr std::size_t most_for_each = 8;  // contacts
  Vec3 way(std::uint32_t shape) const {
    const Shape& s = p_.model.shapes.at_slot(shape);
    return s.body ? finder_.going[s.body.slot - 1].v * p_.h : zero3();
  }
  double turning_of(std::uint32_t shape) const {
    const Shape& s = p_.model.shapes.at_slot(shape);
    return s.body ? turning(finder_.shapes_now[shape], finder_.going[s.body.slot - 1], p_.h) : 0.0;
  }
  void look_along(std::uint32_t shape, FoundContacts& found) {
    const Shape& of = p_.model.shapes.at_slot(shape);
    const ShapeNow& now = finder_.shapes_now[shape];
    if (of.sensor) return;
    std::vector<std::uint32_t> near;
    finder_.broad_phase.along(widened(bounds_of(of.geometry, now.pose), margin_at_rest(now) + turning_of(shape)),
                              way(shape), [&](std::uint32_t other) { near.push_back(other); });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t other : near) add_pair(shape, other, found);
  }
  void add_pair(std::uint32_t shape, std::uint32_t other, FoundContacts& found) {
    const Shape &x = p_.model.shapes.at_slot(shape), &y = p_.model.shapes.at_slot(other);
    const LayerRule* rule = p_.model.layers.rule(x.layer, y.layer);
    if (y.sensor || !may_touch(finder_, x, y, rule)) return;
    const bool in_order = y.body ? shape < other : true;
    const auto [a, b] = in_order ? std::pair(shape, other) : std::pair(other, shape);
    if (are_known(contacts_.list, {a, b, 0, 0}) || !met_.insert({a, b}).second) return;
    const ShapeNow &at = finder_.shapes_now[shape], &there = finder_.shapes_now[other];
    const Vec3 nearing = way(shape) - way(other);
    const double turns = turning_of(shape) + turning_of(other);
    if (!would_meet(x.geometry, at, y.geometry, there, nearing, turns)) return;
    add_contacts(p_, side_of(p_.model, finder_, a), side_of(p_.model, finder_, b), rule,
                 margin_ahead(at, there, nearing, turns), found);
    if (y.body) push(y.body.slot - 1, finder_.going[x.body.slot - 1].v, finder_.going[y.body.slot - 1].w);
  }
  /// What turns far may be anywhere in the ball about it.
  static bool would_meet(const Geometry& a, const ShapeNow& at, const Geometry& b, const ShapeNow& there, Vec3 nearing,
                         double turns) {
    constexpr double far = 0.1;  // of the thickness
    const bool turns_far = turns > far * std::fmin(at.thickness, there.thickness);
    return cast(turns_far ? BallShape{at.reach + turns} : a, at.pose, nearing, b, there.pose).has_value();
  }

  const ThingsNow& p_;
  ContactFinder& finder_;
  const Contacts& contacts_;
  std::map<std::uint32_t, Going> before_;  ///< of those that are pushed
  std::vector<std::uint32_t> waiting_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> met_;
};

/// Whether it goes farther than its margin.
bool goes_beyond(const ThingsNow& p, const ContactFinder& finder, std::uint32_t body, Vec3 v, Vec3 w) {
  for (const ShapeId id : p.model.bodies.at_slot(body).shapes) {
    const ShapeNow& now = finder.shapes_now[id.slot - 1];
    if (p.h * (norm(v) + norm(w) * (norm(now.arm) + now.reach)) > now.margin) return true;
  }
  return false;
}

}  // namespace

bool find_pushed(const ThingsNow& p, ContactFinder& finder, std::span<const TouchIsland> islands, Contacts& contacts) {
  if (finder.changed || finder.sleep_changes != contacts.sleep_changes) put_bounds(p, finder);
  Search search(p, finder, contacts);
  bool any = false;
  for (const TouchIsland& island : islands)
    for (std::size_t i = 0; i < island.things.size(); i++) {
      const IslandBody& b = island.problem.bodies[i];
      if (is_point(island.things[i]) || !goes_beyond(p, finder, island.things[i], b.v, b.w)) continue;
      any = true;
      search.push(island.things[i], b.v, b.w);
    }
  if (!any) return false;
  if (finder.displaced) put_bounds(p, finder);
  FoundContacts found;
  search.run(found);
  if (found.list.empty()) return false;
  std::sort(found.list.begin(), found.list.end(), by_key);
  drop_at_hinges(p, finder.hinged, found.list);
  const std::size_t known = contacts.list.size();
  add_sorted(contacts.list, found.list);
  drop_hidden(p, finder, contacts.list);
  return contacts.list.size() > known;
}

}  // namespace pantin
