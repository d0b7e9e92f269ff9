// From hinges to the order in which a tree is eliminated, and what does not change of it.
#include "base/stable.hpp"
#include "trees/tree.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace pantin {

namespace {

struct Neighbour {
  std::int32_t vertex;  // a node, or the world, which comes after all nodes
  std::uint32_t hinge;
};

/// Who is beside each vertex, one after the other.
struct Graph {
  std::vector<std::uint32_t> first;  // (vertices + 1)
  std::vector<Neighbour> all;

  std::size_t size() const { return first.size() - 1; }
  std::span<const Neighbour> operator[](std::size_t v) const {
    return {all.data() + first[v], all.data() + first[v + 1]};
  }
};

Graph graph_of(std::size_t nodes, std::span<const TreeHinge> hinges, bool anchored) {
  Graph graph;
  graph.first.assign(nodes + (anchored ? 2 : 1), 0);
  const auto vertices = [&](const TreeHinge& h) {
    return std::array{static_cast<std::size_t>(h.a), h.b >= 0 ? static_cast<std::size_t>(h.b) : nodes};
  };
  for (const TreeHinge& h : hinges)
    for (const std::size_t v : vertices(h)) graph.first[v + 1]++;
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  std::vector<std::uint32_t> next(graph.first.begin(), graph.first.end() - 1);
  graph.all.resize(2 * hinges.size());
  for (std::uint32_t k = 0; k < hinges.size(); k++) {
    const auto [a, b] = vertices(hinges[k]);
    graph.all[next[a]++] = {static_cast<std::int32_t>(b), k};
    graph.all[next[b]++] = {static_cast<std::int32_t>(a), k};
  }
  return graph;
}

/// Breadth first from a vertex, or from the two of a hinge: who comes in which order, and from whom.
struct Walk {
  std::vector<std::int32_t> order, parent;
};

Walk walk(const Graph& graph, std::span<const std::int32_t> starts) {
  Walk w;
  w.parent.assign(graph.size(), -1);
  w.order.reserve(graph.size());
  std::vector<char> seen(graph.size(), 0);
  for (std::int32_t start : starts) {
    w.order.push_back(start);
    seen[static_cast<std::size_t>(start)] = 1;
  }
  for (std::size_t i = 0; i < w.order.size(); i++)
    for (const Neighbour& next : graph[static_cast<std::size_t>(w.order[i])]) {
      char& mark = seen[static_cast<std::size_t>(next.vertex)];
      if (mark) continue;
      mark = 1;
      w.parent[static_cast<std::size_t>(next.vertex)] = w.order[i];
      w.order.push_back(next.vertex);
    }
  return w;
}

/// The two vertices of the hinge in the middle of a longest path.
std::array<std::int32_t, 2> middle_of(const Graph& graph) {
  const std::int32_t any = 0;
  const std::int32_t end = walk(graph, {&any, 1}).order.back();
  const Walk back = walk(graph, {&end, 1});
  std::vector<std::int32_t> path;
  for (std::int32_t v = back.order.back(); v >= 0; v = back.parent[static_cast<std::size_t>(v)]) path.push_back(v);
  const std::size_t middle = (path.size() - 1) / 2;
  return {path[middle], path[middle + 1]};
}

/// How many hinges are outside of each vertex, on the longest way.
std::vector<int> heights(const Walk& inwards) {
  std::vector<int> height(inwards.parent.size(), 0);
  for (std::size_t i = inwards.order.size(); i-- > 0;) {
    const auto v = static_cast<std::size_t>(inwards.order[i]);
    if (inwards.parent[v] < 0) continue;
    int& h = height[static_cast<std::size_t>(inwards.parent[v])];
    h = std::max(h, height[v] + 1);
  }
  return height;
}

Vec3 arm_at(const TreeHinge& hinge, std::int32_t node) { return hinge.a == node ? hinge.la : hinge.lb; }

void set_constants(Tree& tree, std::span<const TreeNode> nodes) {
  tree.batches.assign((tree.pairs.size() + 1) / 2,
                      {zero3x4(), zero3x4(), zero3x4(), zero3x4(), lanes(1.0), lanes(0.0), lanes(0.0)});
  tree.masses.reserve(nodes.size());
  tree.extents.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); i++) {
    Tree::Batch& b = tree.batches[tree.slots[i] / batch_size];
    const std::size_t lane = tree.slots[i] % batch_size;
    const Vec3 I = nodes[i].inertia;
    set_lane(b.inverse_inertia, lane, nodes[i].inverse_inertia);
    set_lane(b.inertia_differences, lane, vec(I[1] - I[2], I[2] - I[0], I[0] - I[1]));
    b.inverse_mass[lane] = 1.0 / nodes[i].mass;
    tree.masses.push_back(nodes[i].mass);
    tree.extents.push_back(nodes[i].extent);
    tree.mass += nodes[i].mass;
  }
}

/// A graph's vertices as they are eliminated.
struct Elimination {
  Graph graph;
  std::array<std::int32_t, 2> middle;
  std::vector<std::int32_t> inward;  // (vertices)
  std::vector<int> height;           // (vertices)

  std::size_t outer(std::int32_t v) const { return graph[static_cast<std::size_t>(v)].size() - 1; }
  Tree::Kind kind(std::int32_t v) const {
    return outer(v) == 0 ? Tree::Kind::leaf : outer(v) == 1 ? Tree::Kind::link : Tree::Kind::branch;
  }
};

Elimination find_elimination(std::size_t nodes, std::span<const TreeHinge> hinges, bool anchored) {
  Elimination e;
  e.graph = graph_of(nodes, hinges, anchored);
  e.middle = middle_of(e.graph);
  const Walk inwards = walk(e.graph, e.middle);
  e.height = heights(inwards);
  e.inward = inwards.parent;
  e.inward[static_cast<std::size_t>(e.middle[0])] = e.middle[1];
  e.inward[static_cast<std::size_t>(e.middle[1])] = e.middle[0];
  return e;
}

/// Nodes of the same height and kind are pairs.
void set_pairs(Tree& tree, const Elimination& e) {
  std::vector<std::int32_t> order(tree.nodes);
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t v) { return std::pair{e.height[static_cast<std::size_t>(v)], e.kind(v)}; };
  sort_stably(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  tree.slots.assign(e.graph.size(), 0);
  tree.pairs.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); i++) {
    const bool second =
        i > 0 && tree.slots[static_cast<std::size_t>(order[i - 1])] % 2 == 0 && key(order[i - 1]) == key(order[i]);
    if (!second) {
      tree.pairs.emplace_back();
      tree.pairs.back().kind = e.kind(order[i]);
    }
    tree.slots[static_cast<std::size_t>(order[i])] =
        static_cast<std::uint32_t>(2 * tree.pairs.size() - (second ? 1 : 2));
  }
  tree.world_slot = static_cast<std::uint32_t>(2 * tree.pairs.size());
  if (tree.anchored) tree.slots.back() = tree.world_slot;
  for (Tree::Pair& p : tree.pairs)  // an empty slot has the world on it, or is no branch
    p.outer[0] = p.outer[1] = p.kind == Tree::Kind::branch ? Tree::none : tree.world_slot;
}

/// Arms of a node: `in` to where it leads inwards, `out` to all others.
void set_arms(Tree& tree, const Elimination& e, std::span<const TreeNode> nodes, std::span<const TreeHinge> hinges,
              std::int32_t node) {
  const auto n = static_cast<std::size_t>(node);
  const std::uint32_t slot = tree.slots[n];
  Tree::Pair& pair = tree.pairs[slot / 2];
  Tree::Batch& batch = tree.batches[slot / batch_size];
  const std::size_t lane = slot % batch_size;
  if (pair.kind == Tree::Kind::branch) {
    pair.outer[slot % 2] = static_cast<std::uint32_t>(tree.branches.size());
    const auto first = static_cast<std::uint32_t>(tree.arms.size());
    tree.branches.push_back({slot, first, first + static_cast<std::uint32_t>(e.outer(node))});
  }
  for (const Neighbour& next : e.graph[n]) {
    const Vec3 l = arm_at(hinges[next.hinge], node);
    const std::uint32_t other = tree.slots[static_cast<std::size_t>(next.vertex)];
    if (next.vertex == e.inward[n]) {
      set_lane(batch.in, lane, l);
      batch.turn_per_force_in[lane] = turn_per_force(nodes[n], l);
    } else if (pair.kind == Tree::Kind::link) {
      pair.outer[slot % 2] = other;
      set_lane(batch.out, lane, l);
      batch.turn_per_force_out[lane] = turn_per_force(nodes[n], l);
    } else {
      tree.arms.push_back({other, l, turn_per_force(nodes[n], l)});
    }
  }
}

void set_placements(Tree& tree, const Graph& graph, std::span<const TreeHinge> hinges) {
  const auto world = static_cast<std::int32_t>(tree.nodes), start = tree.anchored ? world : 0;
  const Walk w = walk(graph, {&start, 1});
  tree.placements.reserve(graph.size());
  for (std::int32_t child : w.order) {
    const std::int32_t parent = w.parent[static_cast<std::size_t>(child)];
    if (parent < 0) continue;
    for (const Neighbour& next : graph[static_cast<std::size_t>(child)]) {
      if (next.vertex != parent) continue;
      const TreeHinge& hinge = hinges[next.hinge];
      const bool from_world = parent == world;
      tree.placements.push_back({from_world ? -1 : parent, child, tree.slots[static_cast<std::size_t>(parent)],
                                 tree.slots[static_cast<std::size_t>(child)], next.hinge,
                                 from_world ? zero3() : arm_at(hinge, parent), arm_at(hinge, child)});
    }
  }
}

}  // namespace

Tree make_tree(std::span<const TreeNode> nodes, std::span<const TreeHinge> hinges) {
  Tree tree;
  tree.nodes = static_cast<std::uint32_t>(nodes.size());
  tree.anchored = std::any_of(hinges.begin(), hinges.end(), [](const TreeHinge& h) { return h.b < 0; });
  const Elimination e = find_elimination(nodes.size(), hinges, tree.anchored);
  set_pairs(tree, e);
  set_constants(tree, nodes);
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(nodes.size()); node++)
    set_arms(tree, e, nodes, hinges, node);
  for (Tree::Pair& p : tree.pairs) p.outer_is_pair = p.outer[0] % 2 == 0 && p.outer[1] == p.outer[0] + 1;
  for (const std::size_t k : {0u, 1u}) tree.middle[k] = tree.slots[static_cast<std::size_t>(e.middle[k])];
  set_placements(tree, e.graph, hinges);
  return tree;
}

// Of the axis about which it does most.
double turn_per_force(const TreeNode& node, Vec3 l) {
  double most = 0.0;
  for (int k = 0; k < 3; k++) {
    const double y = l[(k + 1) % 3], z = l[(k + 2) % 3];
    most = std::max(most, std::sqrt(y * y + z * z) * node.inverse_inertia[k]);
  }
  return most;
}

}  // namespace pantin
