#include "contacts/hidden.hpp"

#include <algorithm>
#include <span>

#include "contacts/find_parts.hpp"
#include "shapes/core.hpp"
#include "shapes/distance.hpp"

namespace pantin {

namespace {

constexpr double flush = 5e-4;  // of the size

/// A convex shape of a body, or of the world, that has others, and its contacts with one shape.
struct Neighbour {
  const Geometry& geometry;
  const ShapeNow& now;
  std::span<const Contact> contacts;

  Vec3 farthest_along(Vec3 d) const {
    const Core core = core_of(geometry);
    return now.pose.to_world(support(core, transposed_times(now.pose.R, d))) + d * (core.rounding / norm(d));
  }
  Separation from(Vec3 point) const {
    return separation(BallShape{0.0}, {point, now.pose.R}, geometry, now.pose, infinity);
  }
  /// [m] Of its farthest points along the normal of its contact the nearest.
  Vec3 at(const Contact& c) const {
    constexpr double far = 1e3;  // of the size
    const Vec3 met = c.foreseen ? now.pose.x - now.arm + c.arm_b : c.at;
    return from(met + c.normal * (far * c.size)).on_b;
  }
  /// Whether it lies partly before the plane of a contact of another one.
  bool sticks_out(const Neighbour& other, const Contact& c) const {
    return dot(c.normal, farthest_along(c.normal) - other.farthest_along(c.normal)) > flush * c.size;
  }
  /// Whether it covers what a contact of another one is at.
  bool hides(const Neighbour& other, const Contact& c) const {
    constexpr double toward = 1e-3;
    if (!sticks_out(other, c) || from(other.at(c)).distance > flush * c.size) return false;
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& beside) {
      const Vec3 bare = other.farthest_along(c.normal + beside.normal * toward);
      return !other.sticks_out(*this, beside) && from(bare).distance < flush * c.size;
    });
  }
};

/// Whether a thing, or the world (-1), may have several shapes.
bool is_compound(const Model& model, std::int32_t thing) {
  return thing < 0 || model.bodies.at_slot(static_cast<std::uint32_t>(thing)).shapes.size() > 1;
}

/// Of shapes that one shape has contacts with those that may cover each other.
void find_neighbours(const ThingsNow& p, const ContactFinder& finder, std::span<const Contact> contacts,
                     std::vector<Neighbour>& neighbours) {
  neighbours.clear();
  for (std::size_t first = 0, last; first < contacts.size(); first = last) {
    const Contact& c = contacts[first];
    for (last = first; last < contacts.size() && contacts[last].key.b == c.key.b; last++) continue;
    if (is_of_point(c) || !is_compound(p.model, c.body_b)) continue;
    const Geometry& geometry = p.model.shapes.at_slot(c.key.b).geometry;
    if (is_convex(geometry))
      neighbours.push_back({geometry, finder.shapes_now[c.key.b], contacts.subspan(first, last - first)});
  }
}

/// Keys of contacts, by key, with what is covered of shapes b.
std::vector<ContactKey> hidden_of_b(const ThingsNow& p, const ContactFinder& finder, std::span<const Contact> list) {
  std::vector<Neighbour> neighbours;
  std::vector<ContactKey> hidden;
  for (std::size_t first = 0, last; first < list.size(); first = last) {
    for (last = first; last < list.size() && list[last].key.a == list[first].key.a; last++) continue;
    find_neighbours(p, finder, list.subspan(first, last - first), neighbours);
    for (const Neighbour& one : neighbours)
      for (const Contact& c : one.contacts)
        if (std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& other) {
              return &other != &one && other.contacts[0].body_b == c.body_b && other.hides(one, c);
            }))
          hidden.push_back(c.key);
  }
  return hidden;
}

/// Contacts with shapes a of bodies that have several, as those would be that found them as shapes b.
std::vector<Contact> turned_round(const Model& model, const std::vector<Contact>& list) {
  std::vector<Contact> turned;
  for (const Contact& c : list) {
    if (is_of_point(c) || c.body_b < 0 || !is_compound(model, static_cast<std::int32_t>(c.body_a))) continue;
    Contact& t = turned.emplace_back(c);
    std::swap(t.key.a, t.key.b);
    t.body_a = static_cast<std::uint32_t>(c.body_b);
    t.body_b = static_cast<std::int32_t>(c.body_a);
    t.normal = -c.normal;
    t.arm_b = c.arm_a;
  }
  std::sort(turned.begin(), turned.end(), by_key);
  return turned;
}

}  // namespace

void drop_hidden(const ThingsNow& p, const ContactFinder& finder, std::vector<Contact>& list) {
  std::vector<ContactKey> hidden = hidden_of_b(p, finder, list);
  for (ContactKey key : hidden_of_b(p, finder, turned_round(p.model, list))) {
    std::swap(key.a, key.b);
    hidden.push_back(key);
  }
  if (hidden.empty()) return;
  std::sort(hidden.begin(), hidden.end());
  std::erase_if(list, [&](const Contact& c) { return std::binary_search(hidden.begin(), hidden.end(), c.key); });
}

}  // namespace pantin
