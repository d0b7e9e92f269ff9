#pragma once
// A balanced tree of bounds that are put in and taken out one by one.
#include <array>
#include <cstdint>
#include <vector>

#include "shapes/shape.hpp"

namespace pantin {

/// Each leaf holds a shape's wide bounds, each branch those of its two below. A leaf goes where it adds least surface to the
/// branches over it (Goldsmith and Salmon 1987); heights of two siblings differ by at most one (Adelson-Velsky and Landis
/// 1962), so that 2^32 leaves are less than 48 deep.
class BoundsTree {
 public:
  static constexpr std::uint32_t none = ~0u;

  /// Gives the number of the new leaf.
  std::uint32_t insert(const Bounds& bounds, std::uint32_t shape);
  void erase(std::uint32_t leaf);
  const Bounds& bounds(std::uint32_t leaf) const { return nodes_[leaf].bounds; }

  /// Calls use(shape) for all leaves whose bounds, and those of the branches over them, are such that meets(bounds).
  template <class Meets, class Use>
  void visit(Meets meets, Use use) const;

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t parent = none;  ///< of a free node: the next free one
    std::array<std::uint32_t, 2> child = {none, none};
    std::uint32_t shape = none;
    int height = 0;
    bool is_leaf() const { return child[0] == none; }
  };

  std::uint32_t new_node();
  void free_node(std::uint32_t node);
  std::uint32_t best_sibling(const Bounds& bounds) const;
  void replace_child(std::uint32_t parent, std::uint32_t from, std::uint32_t to);
  void refit(std::uint32_t node);
  void refit_upwards(std::uint32_t node);
  std::uint32_t balance(std::uint32_t node);

  std::vector<Node> nodes_;
  std::uint32_t root_ = none, free_ = none;
};

template <class Meets, class Use>
void BoundsTree::visit(Meets meets, Use use) const {
  if (root_ == none) return;
  std::array<std::uint32_t, 64> open;
  std::size_t count = 0;
  open[count++] = root_;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    if (!meets(node.bounds)) continue;
    if (node.is_leaf()) {
      use(node.shape);
    } else {
      open[count++] = node.child[0];
      open[count++] = node.child[1];
    }
  }
}

}  // namespace pantin
