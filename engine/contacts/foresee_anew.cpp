#include "contacts/foresee_anew.hpp"

#include <algorithm>
#include <vector>

#include "contacts/bodies.hpp"
#include "contacts/find_parts.hpp"
#include "contacts/hidden.hpp"

namespace pantin {

namespace {

constexpr double far = 0.01;  // of the thickness: by so much in the drift

/// Sets how bodies go on that go otherwise. (slots) Which they are.
std::vector<char> go_otherwise(const ThingsNow& p, ContactFinder& finder) {
  std::vector<char> which(p.model.bodies.slots(), 0);
  for (const std::uint32_t shape : finder.moving) {
    const std::uint32_t body = p.model.shapes.at_slot(shape).body.slot - 1;
    const ShapeNow& now = finder.shapes_now[shape];
    if (which[body] || p.model.motion[body].articulate >= 0) continue;
    const BodyState s = state_of(p.model, p.articulates, body, p.drifted);
    const Going& foreseen = finder.going[body];
    const double off = norm(s.v - foreseen.v) + norm(s.w - foreseen.w) * (norm(now.arm) + now.reach);
    if (!(off * p.h > far * now.thickness)) continue;
    finder.going[body] = {s.v, s.w, s.mass};
    which[body] = 1;
  }
  return which;
}

/// [m] By how much the two near each other at a contact in the drift.
double nearing(const ThingsNow& p, const ContactFinder& finder, const Contact& c) {
  const auto velocity = [&](std::uint32_t body) {
    const Going& going = finder.going[body];
    return going.v + cross(going.w, c.at - centre_of(p.model, p.articulates, body, p.drifted));
  };
  const Vec3 of_b = c.body_b < 0 ? zero3() : velocity(static_cast<std::uint32_t>(c.body_b));
  return -dot(c.normal, velocity(c.body_a) - of_b) * p.h;
}

}  // namespace

void foresee_anew(const ThingsNow& p, ContactFinder& finder, Contacts& contacts) {
  constexpr double blow = 0.02;  // of the thickness
  if (finder.rebounding.empty()) return;
  const std::vector<char> otherwise = go_otherwise(p, finder);
  const auto strikes = [&](const Contact& c) {
    return c.foreseen || nearing(p, finder, c) > std::fmax(c.gap, blow * c.size);
  };
  FoundContacts found;
  std::vector<Contact> before;
  for (const auto& [a, b] : finder.rebounding) {
    const Shape &of_a = p.model.shapes.at_slot(a), &of_b = p.model.shapes.at_slot(b);
    if (!otherwise[of_a.body.slot - 1] && !(of_b.body && otherwise[of_b.body.slot - 1])) continue;
    const ContactKey key{a, b, 0, 0};
    const auto first = first_of_shapes(contacts.list, key);
    const auto last =
        std::find_if(first, contacts.list.cend(), [&](const Contact& c) { return !c.key.same_shapes(key); });
    if (first != last && std::none_of(first, last, strikes)) continue;
    const ContactSide side_a = side_of(p.model, finder, a), side_b = side_of(p.model, finder, b);
    const double turns = turning(side_a.now, side_a.going, p.h) + turning(side_b.now, side_b.going, p.h);
    add_contacts(p, side_a, side_b, p.model.layers.rule(of_a.layer, of_b.layer),
                 margin_ahead(side_a.now, side_b.now, (side_a.going.v - side_b.going.v) * p.h, turns), found);
    before.insert(before.end(), first, last);
  }
  if (before.empty() && found.list.empty()) return;
  drop_at_hinges(p, finder.hinged, found.list);
  keep_impulses(before, found.list);
  std::erase_if(contacts.list, [&](const Contact& c) { return are_known(before, c.key); });
  add_sorted(contacts.list, found.list);
  drop_hidden(p, finder, contacts.list);
}

}  // namespace pantin
