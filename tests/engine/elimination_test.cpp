// The order of elimination against its definition, taken literally.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "articulates/build/elimination.hpp"

using namespace pantin;

namespace {

using Sets = std::vector<std::set<std::uint32_t>>;

RowLists lists_of(const Sets& sets) {
  RowLists lists;
  lists.first.push_back(0);
  for (const auto& set : sets) {
    lists.rows.insert(lists.rows.end(), set.begin(), set.end());
    lists.first.push_back(static_cast<std::uint32_t>(lists.rows.size()));
  }
  return lists;
}

void join(Sets& graph, std::uint32_t i, std::uint32_t j) {
  if (i == j) return;
  graph[i].insert(j);
  graph[j].insert(i);
}

Sets chain_graph(std::uint32_t n) {
  Sets graph(n);
  for (std::uint32_t i = 1; i < n; i++) join(graph, i - 1, i);
  return graph;
}

Sets random_graph(std::uint32_t n, int edges, std::uint32_t seed) {
  Sets graph(n);
  const auto next = [&] { return (seed = seed * 1664525u + 1013904223u) >> 8; };
  for (int k = 0; k < edges; k++) {
    const std::uint32_t i = next() % n, j = next() % n;
    join(graph, i, j);
  }
  return graph;
}

/// Columns, in rows, that an order leaves: of each row the later rows that it meets once the earlier ones have gone.
Sets eliminated(Sets graph, const std::vector<std::uint32_t>& order) {
  Sets columns;
  for (const std::uint32_t row : order) {
    columns.push_back(graph[row]);
    for (const std::uint32_t i : columns.back()) {
      for (const std::uint32_t j : columns.back()) join(graph, i, j);
      graph[i].erase(row);
    }
  }
  return columns;
}

}  // namespace

TEST_CASE("graph: a chain is eliminated from both ends and fills nothing in") {
  const Elimination e = minimum_degree(lists_of(chain_graph(7)));
  CHECK(e.order == std::vector<std::uint32_t>{0, 6, 1, 5, 2, 4, 3});
  CHECK(e.columns.rows.size() == 6);
}

TEST_CASE("graph: each row of the order has the least degree of those left, and the columns are what is left of it") {
  for (std::uint32_t seed = 1; seed <= 20; seed++) {
    const Sets graph = random_graph(40, 60, seed);
    const Elimination e = minimum_degree(lists_of(graph));
    REQUIRE(e.order.size() == 40);
    CHECK(std::set<std::uint32_t>(e.order.begin(), e.order.end()).size() == 40);
    const Sets columns = eliminated(graph, e.order);
    Sets left = graph;
    for (std::uint32_t k = 0; k < 40; k++) {
      std::set<std::uint32_t> column;
      for (const std::uint32_t position : e.columns[k]) column.insert(e.order[position]);
      CHECK(column == columns[k]);
      CHECK(std::is_sorted(e.columns[k].begin(), e.columns[k].end()));
      const std::uint32_t row = e.order[k];
      for (std::uint32_t later = k + 1; later < 40; later++) CHECK(left[row].size() <= left[e.order[later]].size());
      for (const std::uint32_t i : columns[k]) {
        for (const std::uint32_t j : columns[k]) join(left, i, j);
        left[i].erase(row);
      }
    }
  }
}

TEST_CASE("graph: each update of the elimination reaches a block of the pattern") {
  const Elimination e = minimum_degree(lists_of(random_graph(30, 50, 7)));
  const Factor f = lay_out(e.columns);
  std::size_t t = 0;
  for (std::uint32_t k = 0; k < f.rows; k++)
    for (std::uint32_t i = f.first[k]; i < f.first[k + 1]; i++)
      for (std::uint32_t j = f.first[k]; j <= i; j++, t++) {
        if (i == j) {
          CHECK(f.target[t] == (f.below[i] | Factor::on_diagonal));
          continue;
        }
        const std::uint32_t block = f.target[t];
        CHECK(f.below[block] == f.below[i]);
        CHECK(f.first[f.below[j]] <= block);
        CHECK(block < f.first[f.below[j] + 1]);
      }
  CHECK(t == f.target.size());
}
