#pragma once
// Which shapes are near each other.
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contacts/bounds_tree.hpp"
#include "shapes/shape.hpp"

namespace pantin {

/// Trees of bounds over shapes, each by a number of its own. Bounds in the trees are wider than what they hold, so that most
/// shapes stay where they are in them: a step in which nothing leaves its wide bounds costs one comparison a shape, and one
/// for each pair of wide bounds that overlap. Such a pair takes 8 bytes, and 8 more where the exact bounds do.
class BroadPhase {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  struct Entry {
    Bounds exact;                            ///< of the shape over the coming step, its margin in them; may be infinite
    std::uint32_t shape;                     ///< the caller's number; memory grows with the largest
    bool moves;                              ///< pairs of two that do not move are not told
    std::uint32_t owner = BoundsTree::none;  ///< nor are those of two that have the same
  };

  /// Adds or moves one; `slack` [m] is by how much its wide bounds exceed the exact ones.
  void put(const Entry& entry, double slack);
  /// Nothing happens where there is no such shape.
  void remove(std::uint32_t shape);
  /// All pairs whose exact bounds overlap and of which one moves, (smaller number, larger number), rising. Valid until the
  /// next change. Throws Error where there are too many.
  std::span<const Pair> pairs();
  /// Calls use(shape) for those whose exact bounds meet a box, or are met by the way of a box swept along `way` [m]; in no
  /// order.
  template <class Use>
  void in_box(const Bounds& box, Use use) const;
  template <class Use>
  void along(const Bounds& box, Vec3 way, Use use) const;

 private:
  enum class Place : std::uint8_t { absent, resting, moving, endless };
  struct Proxy {
    Bounds exact, wide;
    std::uint32_t leaf = BoundsTree::none, owner = BoundsTree::none;
    Place place = Place::absent;
    bool moves = false;
    bool changed = false;  ///< since its pairs were last found
  };

  BoundsTree& tree_of(Place place) { return place == Place::moving ? moving_ : resting_; }
  void take_out(std::uint32_t shape);
  void mark_changed(std::uint32_t shape);
  void find_near(std::uint32_t shape);
  void update_near();
  template <class Meets, class Use>
  void visit(Meets meets, Use use) const;

  std::vector<Proxy> proxies_;  ///< by shape
  BoundsTree resting_, moving_;
  std::vector<std::uint32_t> endless_;  ///< shapes whose bounds are infinite
  std::vector<std::uint32_t> changed_;
  std::size_t own_ = 0;     ///< pairs of one owner, seen since some were last looked for
  std::vector<Pair> near_;  ///< whose wide bounds overlap, rising
  std::vector<Pair> added_, pairs_;
};

/// Whether a box swept along `way` [m] meets bounds.
bool meets_on_way(const Bounds& box, Vec3 way, const Bounds& bounds);

template <class Meets, class Use>
void BroadPhase::visit(Meets meets, Use use) const {
  const auto use_exact = [&](std::uint32_t shape) {
    if (meets(proxies_[shape].exact)) use(shape);
  };
  resting_.visit(meets, use_exact);
  moving_.visit(meets, use_exact);
  for (const std::uint32_t shape : endless_) use_exact(shape);
}

template <class Use>
void BroadPhase::in_box(const Bounds& box, Use use) const {
  visit([&](const Bounds& bounds) { return overlap(box, bounds); }, use);
}

template <class Use>
void BroadPhase::along(const Bounds& box, Vec3 way, Use use) const {
  visit([&](const Bounds& bounds) { return meets_on_way(box, way, bounds); }, use);
}

}  // namespace pantin
