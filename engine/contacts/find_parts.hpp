#pragma once
// The steps of finding contacts, each in a file of its own, and what they have in common.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stable.hpp"
#include "contacts/find.hpp"

namespace pantin {

/// Part of the thickness that the margin of what rests is.
inline constexpr double still_margin = 0.01;

/// [m] The margin of a shape that rests.
inline double margin_at_rest(const ShapeNow& now) {
  return std::isfinite(now.thickness) ? still_margin * now.thickness : 0.0;
}

/// The first contact of two shapes, or of what comes after them, in a list by key.
inline std::vector<Contact>::const_iterator first_of_shapes(const std::vector<Contact>& list, const ContactKey& key) {
  return std::lower_bound(list.begin(), list.end(), key, [](const Contact& c, const ContactKey& k) {
    return std::pair(c.key.a, c.key.b) < std::pair(k.a, k.b);
  });
}

inline bool are_known(const std::vector<Contact>& list, const ContactKey& key) {
  const auto c = first_of_shapes(list, key);
  return c != list.end() && c->key.same_shapes(key);
}

/// Whether they are never to collide.
inline bool are_tied(const ContactFinder& finder, std::uint32_t x, std::uint32_t y) {
  return std::binary_search(finder.tied.begin(), finder.tied.end(), std::pair(std::min(x, y), std::max(x, y)));
}

/// One of two that may touch.
struct ContactSide {
  std::uint32_t key;
  std::int32_t thing;  // or -1: the world
  const Geometry& geometry;
  const ShapeNow& now;
  const Going& going;
  double friction, restitution, rolling, spinning;
  Vec3 belt;  // [m/s]
  bool sensor;
  bool is_solid_point() const { return thing >= 0 && is_point(static_cast<std::uint32_t>(thing)); }
};

inline double restitution_of(double a, double b, const LayerRule* rule) {
  return rule && rule->restitution ? *rule->restitution : std::max(a, b);
}

/// [m] How far a shape gets by turning with its body in a drift of h [s].
inline double turning(const ShapeNow& now, const Going& going, double h) {
  const double angle = std::fmin(norm(going.w) * h, 2.0);
  return angle > 0.0 ? angle * (norm(now.arm) + now.reach) : 0.0;
}

/// [m] How far ahead two are to be looked for, that near each other by a way and turn by so much [m].
inline double margin_ahead(const ShapeNow& a, const ShapeNow& b, Vec3 nearing, double turns) {
  return margin_at_rest(a) + margin_at_rest(b) + norm(nearing) + turns;
}

/// Adds what is found of a pair, gaps up to `margin` [m], by key. `rule`: of their layers, or null.
void add_contacts(const ThingsNow& where, const ContactSide& a, const ContactSide& b, const LayerRule* rule,
                  double margin, FoundContacts& found);

inline bool by_key(const Contact& a, const Contact& b) { return a.key < b.key; }

/// Adds more, by key, to a list by key.
inline void add_sorted(std::vector<Contact>& list, const std::vector<Contact>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(list.size());
  list.insert(list.end(), more.begin(), more.end());
  merge_sorted(list.begin(), list.begin() + middle, list.end(), by_key);
}

/// Whether two shapes may; `rule`: of their layers, or null.
bool may_touch(const ContactFinder& finder, const Shape& a, const Shape& b, const LayerRule* rule);
/// With the shape in this slot.
ContactSide side_of(const Model& model, const ContactFinder& finder, std::uint32_t slot);
/// Those of all pairs of shapes, by key, into the first of `found`.
void find_of_shapes(const ThingsNow& where, ContactFinder& finder, Workers& workers);

/// Leaves out contacts where a hinge is: it keeps these together, so that impulses there would have no bound.
void drop_at_hinges(const ThingsNow& where, const std::vector<HingedPair>& hinged, std::vector<Contact>& list);

/// Finds where solid points are and how they go on.
void locate_points(const ThingsNow& where, ContactFinder& finder);
/// Adds those of solid points; their keys are above those of shapes.
void find_of_points(const ThingsNow& where, ContactFinder& finder, FoundContacts& found);

}  // namespace pantin
