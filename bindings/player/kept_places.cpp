#include "player/kept_places.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pantin::player {

void KeptPositions::keep(KeptPosition place, std::size_t most) {
  const std::uint64_t here = place.tick;
  const auto after = std::upper_bound(positions_.begin(), positions_.end(), here,
                                      [](std::uint64_t t, const KeptPosition& p) { return t < p.tick; });
  positions_.insert(after, std::move(place));
  if (positions_.size() <= most) return;
  std::size_t least = 1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < positions_.size(); i++) {
    const std::uint64_t tick = positions_[i].tick;
    const auto gap = static_cast<double>(positions_[i + 1].tick - positions_[i - 1].tick);
    const auto distance = static_cast<double>(std::max(tick, here) - std::min(tick, here));
    if (gap / (distance + 1.0) >= smallest) continue;
    smallest = gap / (distance + 1.0);
    least = i;
  }
  positions_.erase(positions_.begin() + static_cast<std::ptrdiff_t>(least));
}

const KeptPosition* KeptPositions::before(std::uint64_t tick) const {
  const auto after = std::upper_bound(positions_.begin(), positions_.end(), tick,
                                      [](std::uint64_t t, const KeptPosition& p) { return t < p.tick; });
  return after == positions_.begin() ? nullptr : &*(after - 1);
}

}  // namespace pantin::player
