#include "contacts/pressing.hpp"

#include <algorithm>

#include "contacts/bodies.hpp"

namespace pantin {

namespace {

bool same_things(const Contact& x, const Contact& y) { return x.body_a == y.body_a && x.body_b == y.body_b; }

/// Along their normals [N s], of all contacts of two things.
struct Pressing {
  double last = 0.0, placed = 0.0;  ///< in the last step; to keep them apart in the drift before
};
Pressing pressing_of(const std::vector<Contact>& list, std::size_t first) {
  Pressing p;
  for (std::size_t k = first; k < list.size() && same_things(list[k], list[first]); k++) {
    p.last += dot(list[k].total, list[k].normal);
    p.placed += dot(list[k].place_impulse, list[k].normal);
  }
  return p;
}

/// What presses got about half of its impulse before the drift, as things share loads, and the rest goes on; a blow got all of it
/// before the drift, or all after it.
double share_of_last(const Pressing& p) {
  constexpr double least = 0.25;
  return p.placed > least * p.last ? std::max(0.0, 1.0 - p.placed / p.last) : 0.0;
}

/// Of what was placed, as much as does not exceed all of the last step's: of a blow nothing. That is twice what goes on to press,
/// since how things share a load may differ.
double share_of_placed(const Pressing& p) { return p.placed > 0.0 ? std::clamp(p.last / p.placed, 0.0, 1.0) : 0.0; }

}  // namespace

std::vector<BodyLoad> pressing_impulses(const Model& model, const Articulates& articulates, const Contacts& contacts,
                                        bool drifted) {
  if (contacts.list.empty()) return {};
  double share = 0.0;
  std::vector<BodyLoad> loads(model.bodies.slots() + model.points.slots());
  for (std::size_t k = 0; k < contacts.list.size(); k++) {
    const Contact& c = contacts.list[k];
    if (k == 0 || !same_things(c, contacts.list[k - 1])) {
      const Pressing pressing = pressing_of(contacts.list, k);
      share = drifted ? share_of_placed(pressing) : share_of_last(pressing);
    }
    const Vec3 impulse = (drifted ? c.place_impulse : c.total) * share,
               moment = (drifted ? c.place_moment : c.total_moment) * share;
    const auto add = [&](std::uint32_t thing, double sign) {
      BodyLoad& load = loads[number_of(model, thing)];
      load.force += model.plane.along(impulse) * sign;
      load.moment += (cross(c.at - centre_of(model, articulates, thing, drifted), impulse) + moment) * sign;
    };
    add(c.body_a, 1.0);
    if (c.body_b >= 0) add(static_cast<std::uint32_t>(c.body_b), -1.0);
  }
  return loads;
}

}  // namespace pantin
