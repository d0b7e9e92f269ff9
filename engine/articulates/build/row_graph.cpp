#include "articulates/build/row_graph.hpp"

#include <algorithm>
#include <iterator>

#include "articulates/build/elimination.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

using RowPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Any row of a coupling may become its head, which meets whatever its rows meet.
RowPairs pairs_in_couplings(const std::vector<Edge>& edges, const RowLists& rows_on) {
  RowPairs pairs;
  std::vector<std::uint32_t> coupled;
  for (std::uint32_t k = 0; k < edges.size(); k++)
    if (edges[k].rule->coupled) coupled.push_back(k);
  for (std::uint32_t i : coupled)
    for (std::uint32_t j : coupled) {
      if (edges[i].constraint != edges[j].constraint) continue;
      if (j != i) pairs.emplace_back(i, j);
      for (std::int32_t node : {edges[j].a, edges[j].b})
        if (node >= 0)
          for (std::uint32_t k : rows_on[static_cast<std::size_t>(node)])
            if (k != i) pairs.insert(pairs.end(), {{i, k}, {k, i}});
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// In an order in which what is left of them, once their rows are gone, is eliminated at little cost.
std::vector<std::uint32_t> in_order(const std::vector<std::uint32_t>& hubs, const std::vector<Edge>& edges,
                                    std::size_t nodes) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(nodes, none);
  for (std::uint32_t i = 0; i < hubs.size(); i++) number[hubs[i]] = i;
  std::vector<std::vector<std::uint32_t>> lists(hubs.size());
  for (const Edge& edge : edges) {
    if (edge.a < 0 || edge.b < 0 || edge.a == edge.b) continue;
    const std::uint32_t a = number[static_cast<std::size_t>(edge.a)], b = number[static_cast<std::size_t>(edge.b)];
    if (a == none || b == none) continue;
    lists[a].push_back(b);
    lists[b].push_back(a);
  }
  RowLists graph;
  graph.first.push_back(0);
  for (std::vector<std::uint32_t>& list : lists) {
    std::sort(list.begin(), list.end());
    graph.rows.insert(graph.rows.end(), list.begin(), std::unique(list.begin(), list.end()));
    graph.first.push_back(static_cast<std::uint32_t>(graph.rows.size()));
  }
  std::vector<std::uint32_t> ordered;
  for (const std::uint32_t k : minimum_degree(graph).order) ordered.push_back(hubs[k]);
  return ordered;
}

}  // namespace

std::vector<HubNode> find_hubs(const std::vector<Edge>& edges, const RowLists& rows_on,
                               const std::vector<char>& is_body) {
  constexpr std::ptrdiff_t few = 8;
  const auto rows = [&](std::size_t node) { return std::ssize(rows_on[node]); };
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n + 1 < rows_on.first.size(); n++) {
    if (rows(n) <= few) continue;
    const auto counts = [&](std::uint32_t k) {
      if (edges[k].rule->soft) return true;
      const std::int32_t other = edges[k].a == static_cast<std::int32_t>(n) ? edges[k].b : edges[k].a;
      return other >= 0 && rows(static_cast<std::size_t>(other)) <= few;
    };
    const auto is_coupled = [&](std::uint32_t k) { return edges[k].rule->coupled; };
    const auto list = rows_on[n];
    if (std::count_if(list.begin(), list.end(), counts) > few && std::none_of(list.begin(), list.end(), is_coupled))
      nodes.push_back(n);
  }
  std::vector<HubNode> hubs;
  for (const std::uint32_t n : in_order(nodes, edges, is_body.size()))
    hubs.push_back({n, variables_of(hubs), is_body[n] != 0});
  return hubs;
}

std::uint32_t variables_of(const std::vector<HubNode>& hubs) {
  return hubs.empty() ? 0 : hubs.back().variable + hubs.back().count();
}

RowLists neighbours_of(const std::vector<Edge>& edges, const RowLists& rows_on, const std::vector<HubNode>& hubs) {
  const auto rows = static_cast<std::uint32_t>(edges.size());
  std::vector<const HubNode*> hub_of(rows_on.first.size() - 1, nullptr);
  for (const HubNode& hub : hubs) hub_of[hub.node] = &hub;
  const RowPairs pairs = pairs_in_couplings(edges, rows_on);
  RowLists graph;
  graph.first.reserve(rows + variables_of(hubs) + 1);
  graph.rows.reserve(4 * std::size_t{rows});
  graph.first.push_back(0);
  auto pair = pairs.begin();
  for (std::uint32_t i = 0; i < rows; i++) {
    for (std::int32_t node : {edges[i].a, edges[i].b}) {
      if (node < 0) continue;
      const auto n = static_cast<std::size_t>(node);
      if (const HubNode* hub = hub_of[n]) {
        for (std::uint32_t k = 0; k < hub->count(); k++) graph.rows.push_back(rows + hub->variable + k);
        continue;
      }
      std::copy_if(rows_on[n].begin(), rows_on[n].end(), std::back_inserter(graph.rows),
                   [&](std::uint32_t j) { return j != i; });
    }
    for (; pair != pairs.end() && pair->first == i; ++pair) graph.rows.push_back(pair->second);
    const auto begin = graph.rows.begin() + graph.first.back();
    std::sort(begin, graph.rows.end());
    graph.rows.erase(std::unique(begin, graph.rows.end()), graph.rows.end());
    graph.first.push_back(static_cast<std::uint32_t>(graph.rows.size()));
  }
  for (const HubNode& hub : hubs)
    for (std::uint32_t k = 0; k < hub.count(); k++) {
      graph.rows.insert(graph.rows.end(), rows_on[hub.node].begin(), rows_on[hub.node].end());
      graph.first.push_back(static_cast<std::uint32_t>(graph.rows.size()));
    }
  return graph;
}

}  // namespace pantin
