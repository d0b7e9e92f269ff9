#include <algorithm>

#include "articulates/factor.hpp"
#include "base/check.hpp"

namespace pantin {

namespace {

/// Rows waiting by degree; a row stands in the queue of each degree it has had, and counts only in its present one.
struct Queues {
  std::vector<std::vector<std::uint32_t>> queue;
  std::vector<std::size_t> head;
  std::vector<std::uint32_t> degree;
  std::vector<char> gone;
  std::size_t lowest = 0;

  explicit Queues(std::uint32_t n) : queue(n + 1u), head(n + 1u, 0), degree(n), gone(n, 0) {}

  void put(std::uint32_t row, std::size_t d) {
    degree[row] = static_cast<std::uint32_t>(d);
    queue[d].push_back(row);
    lowest = std::min(lowest, d);
  }
  std::uint32_t take() {
    for (;; lowest++)
      while (head[lowest] < queue[lowest].size()) {
        const std::uint32_t row = queue[lowest][head[lowest]++];
        if (!gone[row] && degree[row] == lowest) {
          gone[row] = 1;
          return row;
        }
      }
  }
};

}  // namespace

Elimination minimum_degree(std::vector<std::vector<std::uint32_t>> neighbours) {
  const auto n = static_cast<std::uint32_t>(neighbours.size());
  Elimination e;
  e.order.resize(n);
  e.columns.resize(n);
  std::vector<std::uint32_t> place(n), merged;
  Queues queues(n);
  for (std::uint32_t i = 0; i < n; i++) queues.put(i, neighbours[i].size());
  for (std::uint32_t k = 0; k < n; k++) {
    const std::uint32_t row = queues.take();
    e.order[k] = row;
    place[row] = k;
    std::vector<std::uint32_t>& clique = e.columns[k];
    clique.swap(neighbours[row]);
    for (std::uint32_t w : clique) {
      merged.clear();
      std::set_union(neighbours[w].begin(), neighbours[w].end(), clique.begin(), clique.end(),
                     std::back_inserter(merged));
      neighbours[w].clear();
      for (std::uint32_t u : merged)
        if (u != w && u != row) neighbours[w].push_back(u);
      queues.put(w, neighbours[w].size());
    }
  }
  for (auto& column : e.columns) {
    for (std::uint32_t& row : column) row = place[row];
    std::sort(column.begin(), column.end());
  }
  return e;
}

Factor lay_out(const Elimination& e) {
  Factor f;
  f.rows = static_cast<std::uint32_t>(e.order.size());
  f.first.assign(1, 0);
  std::size_t tallest = 0;
  for (const auto& column : e.columns) {
    f.below.insert(f.below.end(), column.begin(), column.end());
    f.first.push_back(static_cast<std::uint32_t>(f.below.size()));
    tallest = std::max(tallest, column.size());
  }
  for (const auto& column : e.columns)
    for (std::size_t i = 0; i < column.size(); i++)
      for (std::size_t j = 0; j <= i; j++)
        f.target.push_back(i == j ? column[i] | Factor::on_diagonal : f.block(column[i], column[j]));
  f.diagonal.assign(f.rows, zero33());
  f.lower.assign(f.below.size(), zero33());
  f.upper.assign(f.below.size(), zero33());
  f.floor.assign(f.rows, zero3());
  f.scratch.assign(tallest, zero33());
  return f;
}

std::uint32_t Factor::block(std::uint32_t row, std::uint32_t column) const {
  const auto begin = below.begin() + first[column], end = below.begin() + first[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  assume(found != end && *found == row);
  return static_cast<std::uint32_t>(found - below.begin());
}

}  // namespace pantin
