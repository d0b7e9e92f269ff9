#include "contacts/find.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/stable.hpp"
#include "contacts/bodies.hpp"
#include "contacts/find_parts.hpp"
#include "contacts/hidden.hpp"

namespace pantin {

namespace {

/// Sets how bodies go on: less what contacts stopped in the last drift, since the end of the step does not give that back, or
/// as what rebounds.
void find_going(const Model& model, ContactFinder& finder, const Contacts& contacts) {
  constexpr double least_stop = 1e-6;  // part of the speed: less is round-off
  std::vector<Going>& going = finder.going;
  for (const std::uint32_t s : finder.moving) going[model.shapes.at_slot(s).body.slot - 1] = finder.shapes_now[s].going;
  for (const Contact& c : contacts.list) {
    Going world, &a = going[number_of(model, c.body_a)],
                 &b = c.body_b < 0 ? world : going[number_of(model, static_cast<std::uint32_t>(c.body_b))];
    if (norm2(c.place_impulse) > 0.0) a.is_held = b.is_held = true;
    const double nearing = -dot(c.normal, a.v - b.v), lightness = 1.0 / a.mass + 1.0 / b.mass;
    if (!(nearing > 0.0 && dot(c.place_impulse, c.normal) * lightness > least_stop * nearing)) continue;
    const Vec3 change = c.normal * ((nearing + c.rebound) / lightness);
    a.v += change / a.mass;
    b.v -= change / b.mass;
  }
}

/// Those that were foreseen before the drift that is over and held in it.
std::vector<Contact> held_ahead(const std::vector<Contact>& list) {
  std::vector<Contact> held;
  for (const Contact& c : list) {
    if (!c.foreseen || c.place_index < 0) continue;
    held.push_back(c);
    held.back().from_before = true;
    held.back().gap = 0.0;
  }
  return held;
}

/// Adds them by key; those that their shapes have now are not what was held.
void add_from_before(const std::vector<Contact>& past, std::vector<Contact>& list) {
  if (past.empty()) return;
  const auto is_before = [](const Contact& x, const Contact& y) {
    return std::pair(x.key.a, x.key.b) < std::pair(y.key.a, y.key.b);
  };
  for (Contact& c : list)
    if (std::binary_search(past.begin(), past.end(), c, is_before)) c.place_index = -1;
  add_sorted(list, past);
}

}  // namespace

void drop_at_hinges(const ThingsNow& p, const std::vector<HingedPair>& hinged, std::vector<Contact>& list) {
  constexpr double near = 0.05;  // of the size
  if (hinged.empty()) return;
  const auto is_before = [](const HingedPair& h, const std::pair<std::uint32_t, std::uint32_t>& bodies) {
    return std::pair(h.a, h.b) < bodies;
  };
  std::erase_if(list, [&](const Contact& c) {
    const auto b = static_cast<std::uint32_t>(c.body_b);  // of the world: of no body
    const std::pair bodies(std::min(c.body_a, b), std::max(c.body_a, b));
    auto h = std::lower_bound(hinged.begin(), hinged.end(), bodies, is_before);
    for (; h != hinged.end() && std::pair(h->a, h->b) == bodies; h++) {
      const BodyState s = state_of(p.model, p.articulates, h->a, p.drifted);
      const Vec3 d = c.at - s.x - s.R * h->arm, axis = s.R * h->axis;
      if (norm(d - axis * dot(axis, d)) < near * c.size) return true;
    }
    return false;
  });
}

namespace {

/// What sleeps passes on when it wakes: adds those that were not looked for.
void keep_passing(const ThingsNow& p, std::vector<PassingPair>& now) {
  const auto sleeps = [&](std::uint32_t a) {
    const bool there = is_point(a) ? p.model.points.alive_at(slot_of(a)) : p.model.shapes.alive_at(a);
    if (!there || (!is_point(a) && !p.model.shapes.at_slot(a).body)) return false;
    return asleep(p.model, p.articulates, p.contacts, is_point(a) ? a : p.model.shapes.at_slot(a).body.slot - 1);
  };
  for (const PassingPair& pair : p.contacts.passing)
    if (sleeps(pair.a)) now.push_back(pair);
  std::sort(now.begin(), now.end());
  now.erase(std::unique(now.begin(), now.end()), now.end());
}

/// Where too much is within reach of too much, margins look ahead by less of the step.
void find_near(const ThingsNow& p, ContactFinder& finder) {
  constexpr double least = 1e-3;
  for (finder.ahead = 1.0;; finder.ahead *= 0.1) {
    put_bounds(p, finder);
    try {
      finder.broad_phase.pairs();
      return;
    } catch (const Error&) {
      if (finder.ahead < least) throw;
    }
  }
}

}  // namespace

void find_all_contacts(const ThingsNow& p, ContactFinder& finder, Workers& workers, Contacts& contacts) {
  find_near(p, finder);
  locate_points(p, finder);
  find_going(p.model, finder, contacts);
  find_of_shapes(p, finder, workers);
  FoundContacts& found = finder.found[0];
  if (!finder.solids.empty()) find_of_points(p, finder, found);
  drop_at_hinges(p, finder.hinged, found.list);
  drop_hidden(p, finder, found.list);
  const std::vector<Contact> past = held_ahead(contacts.list);
  std::erase_if(contacts.list, [](const Contact& c) { return c.from_before; });
  keep_impulses(contacts.list, found.list);
  add_from_before(past, found.list);
  keep_passing(p, found.passing);
  contacts.list.swap(found.list);
  contacts.sensed.swap(found.sensed);
  contacts.passing.swap(found.passing);
  contacts.stale = false;
}

}  // namespace pantin
