#include "contacts/hidden.hpp"

#include <algorithm>
#include <span>

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

/// Of shapes that one shape has contacts with those that may cover each other.
void find_neighbours(const ThingsNow& p, const ContactFinder& finder, std::span<const Contact> contacts,
                     std::vector<Neighbour>& neighbours) {
  neighbours.clear();
  for (std::size_t first = 0, last; first < contacts.size(); first = last) {
    const Contact& c = contacts[first];
    for (last = first; last < contacts.size() && contacts[last].key.b == c.key.b; last++) continue;
    if (is_of_point(c)) continue;
    const bool alone = c.body_b >= 0 && p.model.bodies.at_slot(static_cast<std::uint32_t>(c.body_b)).shapes.size() == 1;
    const Geometry& geometry = p.model.shapes.at_slot(c.key.b).geometry;
    if (!alone && is_convex(geometry))
      neighbours.push_back({geometry, finder.shapes_now[c.key.b], contacts.subspan(first, last - first)});
  }
}

}  // namespace

void drop_hidden(const ThingsNow& p, const ContactFinder& finder, std::vector<Contact>& list) {
  std::vector<Neighbour> neighbours;
  std::vector<const Contact*> hidden;
  const std::span<const Contact> all(list);
  for (std::size_t first = 0, last; first < list.size(); first = last) {
    for (last = first; last < list.size() && list[last].key.a == list[first].key.a; last++) continue;
    find_neighbours(p, finder, all.subspan(first, last - first), neighbours);
    for (const Neighbour& one : neighbours)
      for (const Contact& c : one.contacts)
        if (std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& other) {
              return &other != &one && other.contacts[0].body_b == c.body_b && other.hides(one, c);
            }))
          hidden.push_back(&c);
  }
  if (hidden.empty()) return;
  std::erase_if(list, [&](const Contact& c) { return std::binary_search(hidden.begin(), hidden.end(), &c); });
}

}  // namespace pantin
