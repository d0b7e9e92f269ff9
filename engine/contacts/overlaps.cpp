#include "contacts/overlaps.hpp"

#include <algorithm>

#include "base/stable.hpp"
#include "contacts/touching.hpp"

namespace pantin {

namespace {

bool is_deep(const Contact& c) { return -c.gap > deep_overlap * c.size; }

TouchPair pair_of(const Model& model, const Contact& c) { return pantin::pair_of(model, c.body_a, c.body_b, c.key.b); }

/// Pushing out opens at least 5e-3 of the size in a step, and other contacts take their part: thrice the time, and some steps.
std::uint64_t steps_to_half(double part) { return 30 + static_cast<std::uint64_t>(300.0 * std::min(part, 1.0)); }

/// The deepest overlap of two shapes among contacts by key, or null.
const Contact* deepest_of(const std::vector<Contact>& list, std::uint32_t a, std::uint32_t b) {
  const auto is_before = [](const Contact& c, const ContactKey& key) { return c.key < key; };
  const Contact* deepest = nullptr;
  for (auto c = std::lower_bound(list.begin(), list.end(), ContactKey{a, b}, is_before);
       c != list.end() && c->key.a == a && c->key.b == b; c++)
    if (is_deep(*c) && (deepest == nullptr || c->gap < deepest->gap)) deepest = &*c;
  return deepest;
}

}  // namespace

void note_deepest(const Model& model, Contacts& contacts, double time) {
  DeepestOverlap& deepest = contacts.deepest;
  const Contact* found = nullptr;
  double most = std::max(1.01 * deepest.part, deep_overlap);  // what hardly deepens keeps its time
  for (const Contact& c : contacts.list)
    if (-c.gap > most * c.size) {
      found = &c;
      most = -c.gap / c.size;
    }
  if (found != nullptr) deepest = {pair_of(model, *found), -found->gap, most, time};
}

void note_put(Contacts& contacts, std::uint64_t steps) {
  const auto is_before = [](const PutOverlap& x, const PutOverlap& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  };
  for (const Contact& c : contacts.list) {
    if (!is_deep(c)) continue;
    const PutOverlap put{c.key.a, c.key.b, -c.gap, steps + steps_to_half(-c.gap / c.size)};
    const auto at = std::lower_bound(contacts.put.begin(), contacts.put.end(), put, is_before);
    if (at == contacts.put.end() || is_before(put, *at)) contacts.put.insert(at, put);
  }
}

std::vector<Stuck> take_stuck(const Model& model, Contacts& contacts, std::uint64_t steps) {
  std::vector<Stuck> stuck;
  const auto is_due = [&](const PutOverlap& put) { return put.due <= steps; };
  if (std::none_of(contacts.put.begin(), contacts.put.end(), is_due)) return stuck;
  for (const PutOverlap& put : contacts.put) {
    if (!is_due(put)) continue;
    for (const std::vector<Contact>* list : {&contacts.list, &contacts.resting})
      if (const Contact* deepest = deepest_of(*list, put.a, put.b); deepest && -deepest->gap > 0.5 * put.depth)
        stuck.push_back({pair_of(model, *deepest), -deepest->gap});
  }
  std::erase_if(contacts.put, is_due);
  sort_stably(stuck.begin(), stuck.end(), [](const Stuck& x, const Stuck& y) { return x.depth > y.depth; });
  return stuck;
}

}  // namespace pantin
