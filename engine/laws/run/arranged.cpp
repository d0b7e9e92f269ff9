#include "laws/run/arranged.hpp"

#include <algorithm>

namespace pantin {

namespace {

constexpr std::size_t serial_connections = 4096;  // fewer are not worth sharing out
constexpr std::size_t least_range = 1024;         // sites
constexpr std::size_t most_ranges = 32;

struct Ends {
  std::uint32_t low, high;
};

Ends ends_of(const BondList& ties, std::size_t connection) {
  const auto count = static_cast<std::size_t>(ties.count);
  const auto [low, high] =
      std::minmax_element(ties.sites.begin() + static_cast<std::ptrdiff_t>(connection * count),
                          ties.sites.begin() + static_cast<std::ptrdiff_t>((connection + 1) * count));
  return {*low, *high};
}

/// Keeps the order of equal keys.
template <class Key>
void counting_sort(const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to,
                   std::vector<std::uint32_t>& count, std::size_t keys, Key key) {
  count.assign(keys + 1, 0);
  for (const std::uint32_t i : from) count[key(i) + 1]++;
  for (std::size_t k = 1; k < count.size(); k++) count[k] += count[k - 1];
  to.resize(from.size());
  for (const std::uint32_t i : from) to[count[key(i)]++] = i;
}

}  // namespace

void Arranged::arrange(const BondList& ties, std::size_t site_count) {
  n = ties.size();
  number_groups(ties, site_count);
  sort_by_group_and_first(ties, site_count);
  const auto count = static_cast<std::size_t>(ties.count);
  for (std::size_t who = 0; who < count; who++) {
    sites[who].resize(n);
    for (std::size_t k = 0; k < n; k++) sites[who][k] = ties.sites[connection[k] * count + who];
  }
  position.resize(n);
  for (std::size_t k = 0; k < n; k++) position[connection[k]] = static_cast<std::uint32_t>(k);
  parameters.resize(ties.parameters.size());
  for (std::size_t p = 0; p < parameters.size(); p++) {
    parameters[p].assign(n + Sites::padding, 1.0);
    for (std::size_t k = 0; k < n; k++) parameters[p][k] = ties.parameters[p][connection[k]];
  }
}

/// Ranges of sites so wide that from most connections the ends are in one or in neighbouring ones: of such ranges every
/// other one may be gone through at once. A few connections reach further, and come last.
void Arranged::number_groups(const BondList& ties, std::size_t site_count) {
  group_.assign(n, 0);
  ranges_ = 0;
  if (n < serial_connections) return;
  reach_.resize(n);
  for (std::size_t k = 0; k < n; k++) reach_[k] = ends_of(ties, k).high - ends_of(ties, k).low;
  const auto most = reach_.begin() + static_cast<std::ptrdiff_t>(n - 1 - n / 50);
  std::nth_element(reach_.begin(), most, reach_.end());
  const std::size_t width = std::max({least_range, site_count / most_ranges + 1, std::size_t{*most}});
  if (4 * width > site_count) return;
  ranges_ = (site_count + width - 1) / width;
  for (std::size_t k = 0; k < n; k++) {
    const Ends ends = ends_of(ties, k);
    const std::size_t low = ends.low / width, high = ends.high / width;
    group_[k] = static_cast<std::uint32_t>(high <= low + 1 ? low : ranges_);
  }
}

void Arranged::sort_by_group_and_first(const BondList& ties, std::size_t site_count) {
  const auto count = static_cast<std::size_t>(ties.count);
  connection.resize(n);
  for (std::size_t k = 0; k < n; k++) connection[k] = static_cast<std::uint32_t>(k);
  counting_sort(connection, sorted_, count_, site_count, [&](std::uint32_t k) { return ties.sites[k * count]; });
  counting_sort(sorted_, connection, count_, ranges_ + 1, [&](std::uint32_t k) { return group_[k]; });
  phases.assign(ranges_ == 0 ? 1 : 3, {});
  std::size_t begin = 0;
  for (std::size_t group = 0; group <= ranges_; group++) {
    const std::size_t end = count_[group];
    if (end > begin) phases[group < ranges_ ? group % 2 : phases.size() - 1].push_back({begin, end});
    begin = end;
  }
}

}  // namespace pantin
