#include "articulates/build/row_graph.hpp"

#include <algorithm>
#include <iterator>

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

}  // namespace

std::vector<std::uint32_t> find_hubs(const std::vector<Edge>& edges, const RowLists& rows_on) {
  constexpr std::ptrdiff_t few = 8;
  const auto rows = [&](std::size_t node) { return std::ssize(rows_on[node]); };
  std::vector<std::uint32_t> hubs;
  for (std::uint32_t n = 0; n + 1 < rows_on.first.size(); n++) {
    if (rows(n) <= few) continue;
    const auto leads_to_few = [&](std::uint32_t k) {
      const std::int32_t other = edges[k].a == static_cast<std::int32_t>(n) ? edges[k].b : edges[k].a;
      return other >= 0 && rows(static_cast<std::size_t>(other)) <= few;
    };
    const auto is_coupled = [&](std::uint32_t k) { return edges[k].rule->coupled; };
    const auto list = rows_on[n];
    if (std::count_if(list.begin(), list.end(), leads_to_few) > few &&
        std::none_of(list.begin(), list.end(), is_coupled))
      hubs.push_back(n);
  }
  return hubs;
}

RowLists neighbours_of(const std::vector<Edge>& edges, const RowLists& rows_on,
                       const std::vector<std::uint32_t>& hubs) {
  const auto rows = static_cast<std::uint32_t>(edges.size());
  std::vector<std::uint32_t> variable(rows_on.first.size() - 1, 0);  // of a hub, else 0
  for (std::uint32_t i = 0; i < hubs.size(); i++) variable[hubs[i]] = rows + 2 * i;
  const RowPairs pairs = pairs_in_couplings(edges, rows_on);
  RowLists graph;
  graph.first.reserve(rows + 2 * hubs.size() + 1);
  graph.rows.reserve(4 * std::size_t{rows});
  graph.first.push_back(0);
  auto pair = pairs.begin();
  for (std::uint32_t i = 0; i < rows; i++) {
    for (std::int32_t node : {edges[i].a, edges[i].b}) {
      if (node < 0) continue;
      const auto n = static_cast<std::size_t>(node);
      if (variable[n] > 0)
        graph.rows.insert(graph.rows.end(), {variable[n], variable[n] + 1});
      else
        std::copy_if(rows_on[n].begin(), rows_on[n].end(), std::back_inserter(graph.rows),
                     [&](std::uint32_t j) { return j != i; });
    }
    for (; pair != pairs.end() && pair->first == i; ++pair) graph.rows.push_back(pair->second);
    const auto begin = graph.rows.begin() + graph.first.back();
    std::sort(begin, graph.rows.end());
    graph.rows.erase(std::unique(begin, graph.rows.end()), graph.rows.end());
    graph.first.push_back(static_cast<std::uint32_t>(graph.rows.size()));
  }
  for (std::uint32_t hub : hubs)
    for (int k = 0; k < 2; k++) {
      graph.rows.insert(graph.rows.end(), rows_on[hub].begin(), rows_on[hub].end());
      graph.first.push_back(static_cast<std::uint32_t>(graph.rows.size()));
    }
  return graph;
}

}  // namespace pantin
