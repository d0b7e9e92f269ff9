#include "contacts/touching.hpp"

#include <algorithm>

#include "base/stable.hpp"
#include "contacts/bodies.hpp"
#include "contacts/heat.hpp"

namespace pantin {

namespace {

constexpr double closed = 1e-5, apart = 1e-3;  // of the size

TouchPair pair_of(const Model& model, const Contact& c) { return pair_of(model, c.body_a, c.body_b, c.key.b); }

bool senses(const Contact& sensed) { return sensed.gap <= 0.0; }

/// Speed with which two near each other where a sensor is [m/s].
double approach_of(const Model& model, const Articulates& articulates, const Contact& c) {
  const auto velocity = [&](std::uint32_t slot) {
    const BodyState s = state_of(model, articulates, slot, true);
    return s.v + cross(s.w, c.at - s.x);
  };
  const Vec3 of_b = c.body_b < 0 ? zero3() : velocity(static_cast<std::uint32_t>(c.body_b));
  return -dot(c.normal, velocity(c.body_a) - of_b);
}

void add(const Model& model, const Contact& c, double speed, std::vector<Touch>& list) {
  const TouchPair pair = pair_of(model, c);
  if (pair == TouchPair{}) return;
  const double impulse = std::max(0.0, dot(c.normal, c.total));
  const bool turned = pair.a != thing_of(model, c.body_a);
  list.push_back({pair, between(c), turned ? -c.normal : c.normal, impulse, std::max(0.0, speed)});
}

/// One of each pair, rising: impulses add up, what is told of places is their mean by impulse, of speeds the largest.
std::vector<Touch> summed(std::vector<Touch> list) {
  sort_stably(list.begin(), list.end(), [](const Touch& x, const Touch& y) { return x.pair < y.pair; });
  std::vector<Touch> sums;
  for (auto from = list.begin(); from != list.end();) {
    const auto end = std::find_if(from, list.end(), [&](const Touch& t) { return t.pair != from->pair; });
    Touch sum = *from;
    sum.impulse = sum.speed = 0.0;
    Vec3 at = zero3(), normal = zero3();
    for (; from != end; from++) {
      sum.impulse += from->impulse;
      sum.speed = std::max(sum.speed, from->speed);
      at += from->at * from->impulse;
      normal += from->normal * from->impulse;
    }
    if (sum.impulse > 0.0) sum.at = at / sum.impulse;
    if (norm2(normal) > 0.0) sum.normal = direction(normal);
    sums.push_back(sum);
  }
  return sums;
}

/// Pairs of contacts that are such, rising.
template <class Is, class IsSensed>
std::vector<TouchPair> pairs(const Model& model, const Contacts& contacts, Is is, IsSensed is_sensed) {
  std::vector<TouchPair> list;
  const auto add = [&](const std::vector<Contact>& from, auto counts) {
    for (const Contact& c : from)
      if (counts(c)) list.push_back(pair_of(model, c));
  };
  add(contacts.list, is);
  add(contacts.resting, is);
  add(contacts.sensed, is_sensed);
  add(contacts.resting_sensed, is_sensed);
  std::erase(list, TouchPair{});
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

}  // namespace

bool presses(const Contact& c) { return norm2(c.total) > 0.0 || c.gap <= closed * c.size; }

AnyId thing_of(const Model& model, std::uint32_t thing) {
  const std::uint32_t slot = slot_of(thing);
  if (is_point(thing)) return model.points.alive_at(slot) ? AnyId(model.points.at_slot(slot).particle) : AnyId();
  return model.bodies.alive_at(slot) ? AnyId(model.bodies.id_at(slot)) : AnyId();
}

AnyId second_of(const Model& model, std::int32_t body_b, std::uint32_t shape_b) {
  if (body_b >= 0) return thing_of(model, static_cast<std::uint32_t>(body_b));
  return model.shapes.alive_at(shape_b) ? AnyId(model.shapes.id_at(shape_b)) : AnyId();
}

TouchPair pair_of(const Model& model, std::uint32_t body_a, std::int32_t body_b, std::uint32_t shape_b) {
  const AnyId a = thing_of(model, body_a), b = second_of(model, body_b, shape_b), none;
  return a != none && b != none ? TouchPair{std::min(a, b), std::max(a, b)} : TouchPair{};
}

std::vector<TouchPair> touching_now(const Model& model, const Contacts& contacts) {
  return contacts.watched ? contacts.touching : pairs(model, contacts, presses, senses);
}

void watch(const Model& model, Contacts& contacts, bool watched) {
  if (contacts.watched == watched) return;
  contacts.touching = watched ? touching_now(model, contacts) : std::vector<TouchPair>();
  contacts.watched = watched;
  contacts.felt.clear();
}

void feel(const Model& model, const Articulates& articulates, Contacts& contacts) {
  for (const Contact& c : contacts.list)
    if (presses(c)) add(model, c, -c.approach, contacts.felt);
  for (const Contact& c : contacts.sensed)
    if (senses(c)) add(model, c, approach_of(model, articulates, c), contacts.felt);
}

TouchChanges take_changes(const Model& model, Contacts& contacts) {
  const std::vector<Touch> felt = summed(std::move(contacts.felt));
  contacts.felt.clear();
  const auto near = [](const Contact& c) { return c.gap <= apart * c.size; };
  std::vector<TouchPair> now = pairs(model, contacts, near, near);
  const auto among = [](const std::vector<TouchPair>& list, const TouchPair& pair) {
    return std::binary_search(list.begin(), list.end(), pair);
  };
  std::erase_if(now, [&](const TouchPair& pair) { return !among(contacts.touching, pair); });
  const auto kept = static_cast<std::ptrdiff_t>(now.size());
  for (const Touch& touch : felt) now.push_back(touch.pair);
  merge_sorted(now.begin(), now.begin() + kept, now.end());
  now.erase(std::unique(now.begin(), now.end()), now.end());

  TouchChanges changes;
  for (const Touch& touch : felt)
    if (!among(contacts.touching, touch.pair)) {
      changes.touched.push_back(touch);
      changes.touched.back().heat = heat_of(contacts, touch.pair);
    }
  for (const TouchPair& pair : contacts.touching)
    if (!among(now, pair)) changes.parted.push_back(pair);
  contacts.touching = std::move(now);
  return changes;
}

double penetration(const Contacts& contacts) {
  double depth = contacts.slept_depth;
  for (const Contact& c : contacts.list) depth = std::max(depth, -c.gap);
  return depth;
}

void drop_contacts(Contacts& contacts, std::uint32_t thing) {
  const auto is_of = [&](const Contact& c) {
    return c.body_a == thing || (c.body_b >= 0 && static_cast<std::uint32_t>(c.body_b) == thing);
  };
  std::erase_if(contacts.list, is_of);
  std::erase_if(contacts.sensed, is_of);
}

}  // namespace pantin
