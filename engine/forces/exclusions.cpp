// Which pairs of sites leave each other alone.
#include <algorithm>
#include <numeric>

#include "forces/forces_parts.hpp"

namespace pantin {

Exclusions exclusions(std::size_t n, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  Exclusions result;
  if (pairs.empty()) return result;
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  result.begin.assign(n + 1, 0);
  for (const auto& [i, j] : pairs) {
    result.begin[i + 1]++;
    result.list.push_back(j);
  }
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  return result;
}

Exclusions renumbered(const Exclusions& old, std::span<const std::uint32_t> now, std::size_t n) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i + 1 < old.begin.size(); i++)
    for (std::uint32_t j : old.of(i))
      if (now[i] != Forces::none && now[j] != Forces::none) pairs.push_back({now[i], now[j]});
  return exclusions(n, std::move(pairs));
}

/// Pairs of sites with no more than `steps` connections between them.
Exclusions bonded(const Forces& forces, int steps) {
  if (steps <= 0) return {};
  std::vector<std::vector<std::uint32_t>> next(forces.sites.n);
  for (const ActingConnections& acting : forces.connections) {
    const auto count = static_cast<std::size_t>(acting.bond_list.count);
    for (std::size_t k = 0; k < acting.bond_list.sites.size(); k += count)
      for (std::size_t i = 0; i < count; i++)
        for (std::size_t j = 0; j < count; j++)
          if (i != j) next[acting.bond_list.sites[k + i]].push_back(acting.bond_list.sites[k + j]);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> reached, edge, further;
  for (std::uint32_t i = 0; i < forces.sites.n; i++) {
    reached = edge = {i};
    for (int step = 0; step < steps; step++) {
      further.clear();
      for (std::uint32_t j : edge)
        for (std::uint32_t k : next[j])
          if (std::find(reached.begin(), reached.end(), k) == reached.end()) {
            reached.push_back(k);
            further.push_back(k);
            pairs.push_back({i, k});
          }
      edge = further;
    }
  }
  return exclusions(forces.sites.n, std::move(pairs));
}

}  // namespace pantin
