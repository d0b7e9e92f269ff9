#include "contacts/resting.hpp"

#include <algorithm>
#include <iterator>

#include "contacts/bodies.hpp"

namespace pantin {

void sort_resting(const Model& model, const Articulates& articulates, Contacts& contacts) {
  contacts.sleep_changes++;
  const auto rests = [&](const Contact& c) {
    return asleep(model, articulates, contacts, c.body_a) &&
           (c.body_b < 0 || asleep(model, articulates, contacts, static_cast<std::uint32_t>(c.body_b)));
  };
  const auto sort = [&](std::vector<Contact>& list, std::vector<Contact>& resting) {
    std::vector<Contact> all;
    all.reserve(list.size() + resting.size());
    std::merge(list.begin(), list.end(), resting.begin(), resting.end(), std::back_inserter(all),
               [](const Contact& a, const Contact& b) { return a.key < b.key; });
    list.clear();
    resting.clear();
    for (const Contact& c : all) (rests(c) ? resting : list).push_back(c);
  };
  sort(contacts.list, contacts.resting);
  sort(contacts.sensed, contacts.resting_sensed);
  contacts.slept_position = zero3();
  for (const std::uint32_t slot : contacts.sleepers)
    if (const Motion& m = model.motion[slot]; m.articulate < 0) contacts.slept_position += m.x * m.mass;
  contacts.slept_depth = 0.0;
  for (const Contact& c : contacts.resting) contacts.slept_depth = std::max(contacts.slept_depth, -c.gap);
}

}  // namespace pantin
