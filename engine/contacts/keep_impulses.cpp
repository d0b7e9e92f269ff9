#include <algorithm>
#include <span>

#include "contacts/find.hpp"

namespace pantin {

namespace {

constexpr double keeps_up_to = 0.3;  // of the size

/// Those of the same two shapes as this one.
template <class Contacts>
auto of_shapes(Contacts& list, const Contact& contact) {
  const ContactKey first{contact.key.a, contact.key.b, 0, 0};
  const auto begin = std::lower_bound(list.begin(), list.end(), first,
                                      [](const Contact& c, const ContactKey& k) { return c.key < k; });
  auto end = begin;
  while (end != list.end() && end->key.same_shapes(first)) end++;
  return std::span(begin, end);
}

/// Of a point that rebounds, and goes far along faces in one plane in a drift: the nearest with the same normal; nullptr if none.
const Contact* rebounding(std::span<const Contact> before, const Contact& now) {
  constexpr double same_normal = 1e-8;  // of the cosine
  const Contact* best = nullptr;
  for (const Contact& c : before)
    if (c.rebound > 0.0 && dot(c.normal, now.normal) > 1.0 - same_normal &&
        (best == nullptr || norm2(c.at - now.at) < norm2(best->at - now.at)))
      best = &c;
  return best;
}

void add_part(const Contact& from, double part, Contact& to) {
  to.place_impulse += from.place_impulse * part;
  to.total += from.total * part;
  to.place_moment += from.place_moment * part;
  to.total_moment += from.total_moment * part;
}

/// Shares out the impulses of a point that is gone among those of the same two shapes, so that they act where it was, if that
/// is between them: by the weights that are nearest to equal ones.
void share_out(const Contact& from, std::span<Contact> points) {
  constexpr double flat = 1e-3;  // of the spread: that across them is not nothing
  const auto count = static_cast<double>(points.size());
  Vec3 centre = zero3();
  for (const Contact& c : points) centre += c.at / count;
  Mat3 spread = zero33();
  for (const Contact& c : points) spread += outer(c.at - centre, c.at - centre);
  spread += identity33() * (flat * trace(spread) + 1e-12 * from.size * from.size);
  const Vec3 slope = inverse(spread) * (from.at - centre);
  const auto weight = [&](const Contact& c) { return std::max(0.0, 1.0 / count + dot(slope, c.at - centre)); };
  double all = 0.0;
  for (const Contact& c : points) all += weight(c);
  for (Contact& c : points) add_part(from, weight(c) / all, c);
}

/// Of other shapes of the same body, or of the world, the nearest that is near; nullptr if none.
Contact* beside(std::vector<Contact>& list, const Contact& from) {
  Contact* best = nullptr;
  double least = keeps_up_to * from.size;
  auto c = std::lower_bound(list.begin(), list.end(), ContactKey{from.key.a, 0, 0, 0},
                            [](const Contact& one, const ContactKey& k) { return one.key < k; });
  for (; c != list.end() && c->key.a == from.key.a; c++)
    if (const double distance = norm(c->at - from.at); c->body_b == from.body_b && distance < least) {
      best = &*c;
      least = distance;
    }
  return best;
}

}  // namespace

void keep_impulses(const std::vector<Contact>& before, std::vector<Contact>& now) {
  auto old = before.begin();
  std::vector<char> inherited(before.size(), 0);
  std::vector<std::size_t> orphans;
  const auto index_of = [&](const Contact& c) { return static_cast<std::size_t>(&c - before.data()); };
  const auto inherit = [&](Contact& c, const Contact& from) {
    c.place_impulse = from.place_impulse;
    c.total = from.total;
    c.place_moment = from.place_moment;
    c.total_moment = from.total_moment;
    c.approach = from.approach;
    c.rebound = from.rebound;
    c.gap_before = from.gap_before;
    c.turning = from.turning;
    c.closed_beyond = std::max(c.closed_beyond, from.closed_beyond);
    if (from.checks_drift && norm2(from.place_impulse) > 0.0)
      c.closed_beyond = std::max(c.closed_beyond, (std::min(0.0, from.gap) - c.gap) / c.size);
    inherited[index_of(from)] = 1;
  };
  for (std::size_t i = 0; i < now.size(); i++) {
    while (old != before.end() && old->key < now[i].key) old++;
    if (old != before.end() && old->key == now[i].key) {
      inherit(now[i], *old);
      now[i].place_index = old->place_index;
    } else {
      orphans.push_back(i);
    }
  }
  for (const std::size_t i : orphans) {
    const Contact* best = nullptr;
    double least = keeps_up_to * now[i].size;
    for (const Contact& c : of_shapes(before, now[i])) {
      const double distance = norm(c.at - now[i].at);
      if (inherited[index_of(c)] || distance >= least) continue;
      least = distance;
      best = &c;
    }
    if (best == nullptr) best = rebounding(of_shapes(before, now[i]), now[i]);
    if (best != nullptr && !inherited[index_of(*best)]) inherit(now[i], *best);
  }
  for (const Contact& c : before) {
    if (inherited[index_of(c)] || norm2(c.place_impulse) + norm2(c.total) == 0.0) continue;
    if (const std::span<Contact> points = of_shapes(now, c); points.empty()) {
      if (Contact* one = beside(now, c)) add_part(c, 1.0, *one);
    } else if (c.body_b >= 0) {
      share_out(c, points);
    }
  }
}

}  // namespace pantin
