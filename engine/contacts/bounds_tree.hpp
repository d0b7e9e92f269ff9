#pragma once
// A tree of bounds that are put in and taken out one by one.
#include <array>
#include <cstdint>
#include <vector>

#include "shapes/shape.hpp"

namespace pantin {

/// Each leaf holds a shape's wide bounds, each branch those of its two below. A leaf goes where it adds least surface to the
/// branches over it (Goldsmith and Salmon 1987), and each branch over it then exchanges what is below it where that makes one
/// smaller (Kopta et al. 2012). So a visit sees about log n of n leaves that are apart.
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

  /// Where a visit goes on once it is done with all that is below a node.
  std::uint32_t after(std::uint32_t node) const {
    std::uint32_t parent = nodes_[node].parent;
    while (parent != none && nodes_[parent].child[1] == node) node = parent, parent = nodes_[node].parent;
    return parent == none ? none : nodes_[parent].child[1];
  }
  std::uint32_t new_node();
  void free_node(std::uint32_t node);
  std::uint32_t best_sibling(const Bounds& bounds) const;
  void replace_child(std::uint32_t parent, std::uint32_t from, std::uint32_t to);
  void refit(std::uint32_t node);
  void refit_upwards(std::uint32_t node);
  void exchange(std::uint32_t node);

  std::vector<Node> nodes_;
  std::uint32_t root_ = none, free_ = none;
};

template <class Meets, class Use>
void BoundsTree::visit(Meets meets, Use use) const {
  for (std::uint32_t at = root_; at != none;) {
    const Node& node = nodes_[at];
    const bool met = meets(node.bounds);
    if (met && !node.is_leaf()) {
      at = node.child[0];
      continue;
    }
    if (met) use(node.shape);
    at = after(at);
  }
}

}  // namespace pantin
