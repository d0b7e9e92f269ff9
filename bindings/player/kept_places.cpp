#include "player/kept_places.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pantin::player {

void KeptPlaces::keep(KeptPlace place, std::size_t most) {
  const std::uint64_t here = place.tick;
  const auto after = std::upper_bound(places_.begin(), places_.end(), here,
                                      [](std::uint64_t t, const KeptPlace& p) { return t < p.tick; });
  places_.insert(after, std::move(place));
  if (places_.size() <= most) return;
  std::size_t least = 1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i + 1 < places_.size(); i++) {
    const std::uint64_t tick = places_[i].tick;
    const auto gap = static_cast<double>(places_[i + 1].tick - places_[i - 1].tick);
    const auto distance = static_cast<double>(std::max(tick, here) - std::min(tick, here));
    if (gap / (distance + 1.0) >= smallest) continue;
    smallest = gap / (distance + 1.0);
    least = i;
  }
  places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(least));
}

const KeptPlace* KeptPlaces::before(std::uint64_t tick) const {
  const auto after = std::upper_bound(places_.begin(), places_.end(), tick,
                                      [](std::uint64_t t, const KeptPlace& p) { return t < p.tick; });
  return after == places_.begin() ? nullptr : &*(after - 1);
}

}  // namespace pantin::player
