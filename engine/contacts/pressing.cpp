#include "contacts/pressing.hpp"

#include <algorithm>

#include "contacts/bodies.hpp"

namespace pantin {

std::vector<BodyLoad> pressing_impulses(const Model& model, const Articulates& articulates, const Contacts& contacts,
                                        bool drifted) {
  if (contacts.list.empty()) return {};
  std::vector<BodyLoad> loads(model.bodies.slots() + model.points.slots());
  for (const Contact& c : contacts.list) {
    const double last = 0.5 * dot(c.total, c.normal), placed = dot(c.placing, c.normal);
    const double share = !drifted ? 0.5 : placed > 0.0 ? std::clamp(last / placed, 0.0, 1.0) : 0.0;
    const Vec3 impulse = (drifted ? c.placing : c.total) * share,
               moment = (drifted ? c.placing_moment : c.total_moment) * share;
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
