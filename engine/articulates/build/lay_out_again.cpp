// Of an articulate that was read from a file only nodes and rows count: which blocks the matrix has, and who reads what of whom,
// follows from them in the order of elimination, and is not believed.
#include <algorithm>
#include <initializer_list>
#include <numeric>

#include "articulates/build/build.hpp"
#include "articulates/build/elimination.hpp"
#include "articulates/build/row_graph.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/tree_drift.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"
#include "trees/tree.hpp"

namespace pantin {

namespace {

void sound(bool good) { require(good, "an articulate in it contradicts itself"); }

bool is_below(std::int32_t index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

void check_rows(const Articulate& a) {
  sound(!a.nodes.empty() && !a.rows.empty());
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const Row& row = a.rows[k];
    sound(is_below(row.a, a.nodes.size()) && (row.b == -1 || is_below(row.b, a.nodes.size())) && row.a != row.b);
    sound(row.condition == -1 ? row.rule == &rigid_row && row.member && row.star_point
                              : is_below(row.condition, a.conditions.size()) && condition(a, row).row == k);
    if (row.rule == &stiff_row) sound(condition(a, row).stiff != nullptr);
    if (row.rule == &path_row) sound(static_cast<bool>(condition(a, row).constraint));
  }
  for (const Condition& c : a.conditions)
    sound(c.row < a.rows.size() && a.conditions.data() + row(a, c).condition == &c);
}

std::vector<Edge> edges_of(const Articulate& a) {
  std::vector<Edge> edges(a.rows.size());
  for (std::size_t k = 0; k < edges.size(); k++) {
    const Row& row = a.rows[k];
    edges[k].rule = row.rule;
    edges[k].a = row.a;
    edges[k].b = row.b;
    if (row.condition >= 0) edges[k].constraint = condition(a, row).constraint;
  }
  return edges;
}

/// By their variables.
std::vector<HubNode> hubs_of(const Articulate& a) {
  std::vector<HubNode> hubs;
  std::uint32_t next = 0;
  for (const Hub& hub : a.hubs) {
    sound(hub.node >= next && hub.node < a.nodes.size() && hub.variable >= a.rows.size());
    hubs.push_back({hub.node, hub.variable - static_cast<std::uint32_t>(a.rows.size()), a.nodes[hub.node].is_body});
    next = hub.node + 1;
  }
  std::sort(hubs.begin(), hubs.end(), [](const HubNode& x, const HubNode& y) { return x.variable < y.variable; });
  std::uint32_t first = 0;
  for (const HubNode& hub : hubs) {
    sound(hub.variable == first);
    first += hub.count();
  }
  return hubs;
}

/// The distance whose axis a row turns is in its coupling.
void check_couplings(const Articulate& a) {
  for (const Coupling& coupling : a.couplings)
    for (const std::uint32_t k : coupling.rows) {
      const Condition& turning = condition(a, a.rows[k]);
      sound(a.rows[k].lever > 0.0 || !turning.turns_axis);
      sound(!turning.turns_axis || std::any_of(coupling.rows.begin(), coupling.rows.end(), [&](std::uint32_t j) {
        return a.rows[j].lever == 0.0 && condition(a, a.rows[j]).index == turning.index;
      }));
    }
}

/// Whether its rows lead to each node in one way, and to the world in at most one.
bool is_one_tree(const Articulate& a) {
  const auto to_world = std::count_if(a.rows.begin(), a.rows.end(), [](const Row& row) { return row.b < 0; });
  if (to_world > 1 || a.rows.size() + 1 != a.nodes.size() + static_cast<std::size_t>(to_world)) return false;
  std::vector<std::size_t> root(a.nodes.size() + 1);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  return std::all_of(a.rows.begin(), a.rows.end(), [&](const Row& row) {
    const std::size_t x = find(static_cast<std::size_t>(row.a)),
                      y = find(row.b < 0 ? a.nodes.size() : static_cast<std::size_t>(row.b));
    root[x] = y;
    return x != y;
  });
}

void check_lists(const Articulate& a) {
  const std::size_t rows = a.rows.size(), nodes = a.nodes.size();
  const auto all_or_none = [](std::size_t whole, std::initializer_list<std::size_t> sizes) {
    for (const std::size_t size : sizes) sound(size == 0 || size == whole);
  };
  all_or_none(rows, {a.impulses.size(), a.exerted.size(), a.expected.size(), a.reaction.size(), a.loads.size(),
                     a.symmetric_impulses.size(), a.tie_impulses[0].size(), a.tie_impulses[1].size(),
                     a.scalar_impulses[0].size(), a.scalar_impulses[1].size()});
  all_or_none(nodes, {a.means.size(), a.rest.pulls.size(), a.saved.size()});
  sound(a.impulses.size() == rows && a.symmetric_impulses.size() == rows && a.f_saved.size() == rows);
  sound(a.exerted_time == 0.0 || a.exerted.size() == rows);
  sound(a.predictor.forces.size() == rows && a.predictor.known <= Predictor::levels);
  for (const Condition& c : a.conditions)
    sound(!c.stiff || c.energy_given.empty() || c.energy_given.size() == c.stiff->curves.size());
}

/// Where the tree is: either nowhere, or of all its batches.
void check_course(const Articulate& a) {
  const std::size_t batches = a.as_tree ? a.as_tree->batches.size() : 0;
  const TreeCourse& course = a.course;
  sound(!a.by_tree || (a.as_tree && course.end.size() == batches && course.end_rates.size() == batches));
  if (!a.by_tree || course.fresh) return;
  for (const TreeState& part : course.coefficients) sound(part.size() == batches);
}

void take_layout(Articulate& a, Articulate& laid_out) {
  a.hubs = std::move(laid_out.hubs);
  a.row_blocks = std::move(laid_out.row_blocks);
  a.first_row_block = std::move(laid_out.first_row_block);
  a.rows_on = std::move(laid_out.rows_on);
  a.couplings = std::move(laid_out.couplings);
  a.tiles = std::move(laid_out.tiles);
  Factor &old = a.factor, &now = laid_out.factor;
  sound(old.diagonal.size() == now.rows && old.whole.size() == now.rows && old.lower.size() == now.below.size() &&
        old.upper.size() == now.below.size() && a.right_side.size() == now.rows);
  old.rows = now.rows;
  old.first = std::move(now.first);
  old.below = std::move(now.below);
  old.target = std::move(now.target);
  old.scratch.resize(now.scratch.size());
  sound(a.at_ends.size() == laid_out.at_ends.size() && a.ends.size() == laid_out.ends.size() &&
        a.batches.size() == laid_out.batches.size() && a.predictor.rates.size() == a.batches.size());
  for (std::size_t i = 0; i < a.ends.size(); i++) {
    a.ends[i].row = laid_out.ends[i].row;
    a.ends[i].to = laid_out.ends[i].to;
  }
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    a.batches[b].first_row = laid_out.batches[b].first_row;
    a.batches[b].first_end = laid_out.batches[b].first_end;
    a.batches[b].last_end = laid_out.batches[b].last_end;
    a.batches[b].count = laid_out.batches[b].count;
  }
}

}  // namespace

void lay_out_again(Articulate& a) {
  check_rows(a);
  Articulate laid_out;
  laid_out.nodes = a.nodes;
  laid_out.rows = a.rows;
  laid_out.conditions = a.conditions;
  for (const Hub& hub : a.hubs) laid_out.hubs.push_back({hub.node, hub.variable, {}, {}});
  const std::vector<HubNode> hubs = hubs_of(a);
  const std::vector<Edge> edges = edges_of(a);
  const RowLists graph = neighbours_of(edges, rows_of_nodes(a.nodes.size(), edges), hubs);
  const auto rows = static_cast<std::uint32_t>(a.rows.size()) + variables_of(hubs);
  laid_out.factor = lay_out(minimum_degree(graph, rows).columns);
  find_row_blocks(laid_out);
  lay_out_batches(laid_out);
  find_tiles(laid_out);
  take_layout(a, laid_out);
  check_couplings(a);
  check_lists(a);
  if (a.tree_sought && is_one_tree(a))
    find_tree(a);
  else
    a.as_tree = nullptr;
  check_course(a);
}

}  // namespace pantin
