// Contacts of all pairs of shapes.
#include <algorithm>

#include "base/subnormals.hpp"
#include "contacts/find_parts.hpp"

namespace pantin {

namespace {

/// Pairs that may touch, first the slot of a contact's shape a, in the order of their keys.
void choose_pairs(const Model& model, ContactFinder& finder) {
  finder.pairs.clear();
  for (const auto& [first, second] : finder.broad_phase.pairs()) {
    const Shape &x = model.shapes.at_slot(first), &y = model.shapes.at_slot(second);
    const LayerRule* rule = model.layers.rule(x.layer, y.layer);
    if (!may_touch(finder, x, y, rule)) continue;
    finder.pairs.push_back(x.body ? BroadPhase::Pair(first, second) : BroadPhase::Pair(second, first));
  }
  if (!std::is_sorted(finder.pairs.begin(), finder.pairs.end())) std::sort(finder.pairs.begin(), finder.pairs.end());
  finder.rebounding.clear();
  for (const auto& [a, b] : finder.pairs) {
    const Shape &x = model.shapes.at_slot(a), &y = model.shapes.at_slot(b);
    if (!x.sensor && !y.sensor &&
        restitution_of(x.material.restitution, y.material.restitution, model.layers.rule(x.layer, y.layer)) > 0.0)
      finder.rebounding.emplace_back(a, b);
  }
}

/// How its surface moves on it [m/s], world axes.
Vec3 belt_of(const Shape& shape, const ShapeNow& now) {
  const Vec3 v = shape.material.surface_velocity;
  return norm2(v) == 0.0 ? v : now.pose.R * transposed_times(matrix(shape.orientation), v);
}

void find_of_pair(const ThingsNow& p, const ContactFinder& finder, BroadPhase::Pair pair, FoundContacts& found) {
  const auto [a, b] = pair;
  const LayerRule* rule = p.model.layers.rule(p.model.shapes.at_slot(a).layer, p.model.shapes.at_slot(b).layer);
  add_contacts(p, side_of(p.model, finder, a), side_of(p.model, finder, b), rule,
               finder.shapes_now[a].margin + finder.shapes_now[b].margin, found);
}

}  // namespace

bool may_touch(const ContactFinder& finder, const Shape& a, const Shape& b, const LayerRule* rule) {
  if (rule && !rule->collide) return false;
  if (!a.body && !b.body) return false;
  return !a.body || !b.body || (a.body != b.body && !are_tied(finder, a.body.slot - 1, b.body.slot - 1));
}

ContactSide side_of(const Model& model, const ContactFinder& finder, std::uint32_t slot) {
  const Shape& s = model.shapes.at_slot(slot);
  const ShapeNow& at = finder.shapes_now[slot];
  return {slot,
          s.body ? static_cast<std::int32_t>(s.body.slot - 1) : -1,
          s.geometry,
          at,
          s.body ? finder.going[s.body.slot - 1] : at.going,
          s.material.friction,
          s.material.restitution,
          s.material.rolling,
          s.material.spinning,
          belt_of(s, at),
          s.sensor};
}

void find_of_shapes(const ThingsNow& p, ContactFinder& finder, Workers& workers) {
  choose_pairs(p.model, finder);
  constexpr std::size_t enough = 24;  // some 20 us of work: a thread is slow to wake
  const std::size_t count = finder.pairs.size();
  const std::size_t blocks = workers.count() == 1 ? 1 : std::clamp<std::size_t>(count / enough, 1, 64);
  if (finder.found.size() < blocks) finder.found.resize(blocks);
  workers.run(blocks, [&](std::size_t block, int) {
    const SubnormalsAreZero subnormals_are_zero;
    FoundContacts& found = finder.found[block];
    found.list.clear();
    found.sensed.clear();
    found.passing.clear();
    for (std::size_t k = count * block / blocks; k < count * (block + 1) / blocks; k++)
      find_of_pair(p, finder, finder.pairs[k], found);
  });
  const auto append = [](auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); };
  FoundContacts& all = finder.found[0];
  for (std::size_t block = 1; block < blocks; block++) {
    append(all.list, finder.found[block].list);
    append(all.sensed, finder.found[block].sensed);
    append(all.passing, finder.found[block].passing);
  }
}

}  // namespace pantin
