#include "articulates/build/elimination.hpp"

#include <algorithm>

namespace pantin {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// Rows waiting by degree; a row stands in the queue of each degree it has had, and counts only in its present one.
class Queues {
 public:
  explicit Queues(std::uint32_t n) : head_(n + 1u, none), tail_(n + 1u, none), degree_(n), gone_(n, 0) {
    waiting_.reserve(3 * std::size_t{n});
  }

  void put(std::uint32_t row, std::uint32_t d) {
    degree_[row] = d;
    const auto position = static_cast<std::uint32_t>(waiting_.size());
    waiting_.push_back({row, none});
    (head_[d] == none ? head_[d] : waiting_[tail_[d]].next) = position;
    tail_[d] = position;
    lowest_ = std::min(lowest_, d);
  }
  std::uint32_t take() {
    for (;; lowest_++)
      while (head_[lowest_] != none) {
        const Waiting w = waiting_[head_[lowest_]];
        head_[lowest_] = w.next;
        if (gone_[w.row] || degree_[w.row] != lowest_) continue;
        gone_[w.row] = 1;
        return w.row;
      }
  }

 private:
  struct Waiting {
    std::uint32_t row, next;
  };
  std::vector<Waiting> waiting_;
  std::vector<std::uint32_t> head_, tail_, degree_;
  std::vector<char> gone_;
  std::uint32_t lowest_ = 0;
};

/// Lists that change, in one piece of memory: one that outgrows its place moves to the end.
class ChangingLists {
 public:
  explicit ChangingLists(const RowLists& lists) : rows_(lists.rows) {
    for (std::size_t i = 0; i + 1 < lists.first.size(); i++) {
      const std::uint32_t size = lists.first[i + 1] - lists.first[i];
      positions_.push_back({lists.first[i], size, size});
    }
  }
  std::span<const std::uint32_t> operator[](std::uint32_t k) const {
    return {rows_.data() + positions_[k].first, positions_[k].size};
  }
  void set(std::uint32_t k, const std::vector<std::uint32_t>& list) {
    Place& p = positions_[k];
    p.size = static_cast<std::uint32_t>(list.size());
    if (p.size > p.room) {
      p.first = static_cast<std::uint32_t>(rows_.size());
      p.room = p.size;
      rows_.resize(rows_.size() + p.size);
    }
    std::copy(list.begin(), list.end(), rows_.begin() + p.first);
  }

 private:
  struct Place {
    std::uint32_t first, size, room;
  };
  std::vector<std::uint32_t> rows_;
  std::vector<Place> positions_;
};

}  // namespace

Elimination minimum_degree(const RowLists& given, std::uint32_t late, std::size_t most) {
  const auto n = static_cast<std::uint32_t>(given.first.size() - 1), early = n - late;
  ChangingLists neighbours(given);
  Elimination e;
  e.order.resize(n);
  e.columns.first.reserve(n + 1u);
  e.columns.rows.reserve(given.rows.size());
  e.columns.first.push_back(0);
  std::vector<std::uint32_t> position(n), clique, merged;
  Queues queues(n);
  for (std::uint32_t i = 0; i < early; i++) queues.put(i, given.first[i + 1] - given.first[i]);
  std::size_t squares = 0;
  for (std::uint32_t k = 0; k < n; k++) {
    const std::uint32_t row = k < early ? queues.take() : k;
    e.order[k] = row;
    position[row] = k;
    clique.assign(neighbours[row].begin(), neighbours[row].end());
    squares += clique.size() * clique.size();
    if (squares > most) return {};
    for (std::uint32_t w : clique) {
      merged.clear();
      std::set_union(neighbours[w].begin(), neighbours[w].end(), clique.begin(), clique.end(),
                     std::back_inserter(merged));
      std::erase_if(merged, [&](std::uint32_t u) { return u == w || u == row; });
      neighbours.set(w, merged);
      if (w < early) queues.put(w, static_cast<std::uint32_t>(merged.size()));
    }
    e.columns.rows.insert(e.columns.rows.end(), clique.begin(), clique.end());
    e.columns.first.push_back(static_cast<std::uint32_t>(e.columns.rows.size()));
  }
  for (std::uint32_t& row : e.columns.rows) row = position[row];
  for (std::uint32_t k = 0; k < n; k++)
    std::sort(e.columns.rows.begin() + e.columns.first[k], e.columns.rows.begin() + e.columns.first[k + 1]);
  return e;
}

Factor lay_out(RowLists columns) {
  Factor f;
  f.rows = static_cast<std::uint32_t>(columns.first.size() - 1);
  f.first = std::move(columns.first);
  f.below = std::move(columns.rows);
  std::size_t tallest = 0, updates = 0;
  for (std::uint32_t k = 0; k < f.rows; k++) {
    const std::size_t count = f.first[k + 1] - f.first[k];
    tallest = std::max(tallest, count);
    updates += count * (count + 1) / 2;
  }
  f.target.reserve(updates);
  for (std::uint32_t k = 0; k < f.rows; k++)
    for (std::uint32_t i = f.first[k]; i < f.first[k + 1]; i++) {
      for (std::uint32_t j = f.first[k]; j < i; j++) f.target.push_back(f.block(f.below[i], f.below[j]));
      f.target.push_back(f.below[i] | Factor::on_diagonal);
    }
  f.diagonal.resize(f.rows);
  f.lower.resize(f.below.size());
  f.upper.resize(f.below.size());
  f.whole.resize(f.rows);
  f.scratch.resize(tallest);
  return f;
}

}  // namespace pantin
