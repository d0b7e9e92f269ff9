#include "contacts/bounds_tree.hpp"

#include <algorithm>

namespace pantin {

namespace {

Bounds joined(const Bounds& a, const Bounds& b) {
  return {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}

/// Half the surface [m²].
double half_surface(const Bounds& b) {
  const Vec3 d = b.high - b.low;
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

}  // namespace

std::uint32_t BoundsTree::new_node() {
  if (free_ == none) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].parent;
  nodes_[node] = {};
  return node;
}

void BoundsTree::free_node(std::uint32_t node) {
  nodes_[node].parent = free_;
  free_ = node;
}

std::uint32_t BoundsTree::best_sibling(const Bounds& bounds) const {
  std::uint32_t at = root_;
  double inherited = 0.0;
  while (!nodes_[at].is_leaf()) {
    const Node& node = nodes_[at];
    const double with_new = half_surface(joined(node.bounds, bounds));
    const double cost_here = with_new + inherited;
    inherited += with_new - half_surface(node.bounds);
    std::array<double, 2> cost;
    for (std::size_t i = 0; i < 2; i++) {
      const Node& child = nodes_[node.child[i]];
      cost[i] = half_surface(joined(child.bounds, bounds)) + inherited;
      if (!child.is_leaf()) cost[i] -= half_surface(child.bounds);
    }
    if (cost_here < cost[0] && cost_here < cost[1]) break;
    at = node.child[cost[0] <= cost[1] ? 0 : 1];
  }
  return at;
}

std::uint32_t BoundsTree::insert(const Bounds& bounds, std::uint32_t shape) {
  const std::uint32_t leaf = new_node();
  nodes_[leaf].bounds = bounds;
  nodes_[leaf].shape = shape;
  if (root_ == none) {
    root_ = leaf;
    return leaf;
  }
  const std::uint32_t sibling = best_sibling(bounds), branch = new_node(), parent = nodes_[sibling].parent;
  nodes_[branch].parent = parent;
  nodes_[branch].child = {sibling, leaf};
  replace_child(parent, sibling, branch);
  nodes_[sibling].parent = nodes_[leaf].parent = branch;
  refit_upwards(branch);
  return leaf;
}

void BoundsTree::erase(std::uint32_t leaf) {
  const std::uint32_t branch = nodes_[leaf].parent;
  free_node(leaf);
  if (branch == none) {
    root_ = none;
    return;
  }
  const std::uint32_t sibling = nodes_[branch].child[nodes_[branch].child[0] == leaf ? 1 : 0],
                      parent = nodes_[branch].parent;
  nodes_[sibling].parent = parent;
  replace_child(parent, branch, sibling);
  free_node(branch);
  refit_upwards(parent);
}

void BoundsTree::replace_child(std::uint32_t parent, std::uint32_t from, std::uint32_t to) {
  if (parent == none)
    root_ = to;
  else
    nodes_[parent].child[nodes_[parent].child[0] == from ? 0 : 1] = to;
}

void BoundsTree::refit(std::uint32_t node) {
  Node& n = nodes_[node];
  const Node &first = nodes_[n.child[0]], &second = nodes_[n.child[1]];
  n.bounds = joined(first.bounds, second.bounds);
  n.height = 1 + std::max(first.height, second.height);
}

void BoundsTree::refit_upwards(std::uint32_t node) {
  while (node != none) {
    refit(node);
    exchange(node);
    node = nodes_[node].parent;
  }
}

/// Exchanges a side of a node for a half of the other side, where that makes the other side smaller, or leaves it as large and
/// the node less high.
void BoundsTree::exchange(std::uint32_t node) {
  const auto height = [&](std::uint32_t i) { return nodes_[i].height; };
  double best = 0.0;
  std::size_t side = 0, half = 0;
  bool found = false;
  for (std::size_t s = 0; s < 2; s++) {
    const std::uint32_t lone = nodes_[node].child[s], other = nodes_[node].child[1 - s];
    if (nodes_[other].is_leaf()) continue;
    for (std::size_t k = 0; k < 2; k++) {
      const std::uint32_t leaves = nodes_[other].child[k], stays = nodes_[other].child[1 - k];
      const double gain =
          half_surface(nodes_[other].bounds) - half_surface(joined(nodes_[lone].bounds, nodes_[stays].bounds));
      const bool lower = height(leaves) > std::max(height(lone), height(stays));
      if (!(gain > best || (gain == 0.0 && !found && lower))) continue;
      best = gain, side = s, half = k, found = true;
    }
  }
  if (!found) return;
  const std::uint32_t lone = nodes_[node].child[side], other = nodes_[node].child[1 - side],
                      leaves = nodes_[other].child[half];
  nodes_[node].child[side] = leaves;
  nodes_[other].child[half] = lone;
  nodes_[leaves].parent = node;
  nodes_[lone].parent = other;
  refit(other);
  refit(node);
}

}  // namespace pantin
