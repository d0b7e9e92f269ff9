#include "contacts/broad_phase.hpp"

#include <algorithm>
#include <utility>

#include "contacts/crowd.hpp"

namespace pantin {

namespace {

/// Wide bounds that exceed the exact ones by more than so many slacks are made anew.
constexpr double most_slacks = 4.0;
/// So many pairs of one owner take as long as one of two.
constexpr std::size_t cheap = 10;

bool contains(const Bounds& outer, const Bounds& inner) {
  for (int i = 0; i < 3; i++)
    if (inner.low[i] < outer.low[i] || inner.high[i] > outer.high[i]) return false;
  return true;
}

/// Merges the rising first `kept` of a list with a rising list that takes the places behind them.
void merge_from_back(std::vector<BroadPhase::Pair>& list, std::ptrdiff_t kept,
                     const std::vector<BroadPhase::Pair>& added) {
  auto old = list.begin() + kept;
  auto to = list.end();
  for (auto next = added.end(); next != added.begin();)
    *--to = old != list.begin() && *(next - 1) < *(old - 1) ? *--old : *--next;
}

bool is_endless(const Bounds& bounds) { return !finite(bounds.low) || !finite(bounds.high); }

}  // namespace

bool meets_on_way(const Bounds& box, Vec3 way, const Bounds& bounds) {
  double from = 0.0, to = 1.0;
  for (int i = 0; i < 3; i++) {
    const double before = bounds.low[i] - box.high[i], after = bounds.high[i] - box.low[i];
    if (way[i] == 0.0) {
      if (before > 0.0 || after < 0.0) return false;
      continue;
    }
    const double first = before / way[i], second = after / way[i];
    from = std::fmax(from, std::fmin(first, second));
    to = std::fmin(to, std::fmax(first, second));
  }
  return from <= to;
}

void BroadPhase::put(const Entry& entry, double slack) {
  if (entry.shape >= proxies_.size()) proxies_.resize(entry.shape + 1);
  Proxy& proxy = proxies_[entry.shape];
  const bool endless = is_endless(entry.exact);
  const Place place = endless ? Place::endless : entry.moves ? Place::moving : Place::resting;
  proxy.exact = entry.exact;
  const bool other_owner = std::exchange(proxy.owner, entry.owner) != entry.owner;
  if (!other_owner && place == proxy.place && entry.moves == proxy.moves && contains(proxy.wide, entry.exact) &&
      (endless || contains(widened(entry.exact, most_slacks * slack), proxy.wide)))
    return;

  take_out(entry.shape);
  proxy.wide = widened(entry.exact, slack);
  proxy.place = place;
  proxy.moves = entry.moves;
  if (endless)
    endless_.push_back(entry.shape);
  else
    proxy.leaf = tree_of(place).insert(proxy.wide, entry.shape);
  mark_changed(entry.shape);
}

void BroadPhase::remove(std::uint32_t shape) {
  if (shape >= proxies_.size() || proxies_[shape].place == Place::absent) return;
  take_out(shape);
  mark_changed(shape);
}

void BroadPhase::take_out(std::uint32_t shape) {
  Proxy& proxy = proxies_[shape];
  if (proxy.place == Place::endless)
    std::erase(endless_, shape);
  else if (proxy.place != Place::absent)
    tree_of(proxy.place).erase(proxy.leaf);
  proxy.place = Place::absent;
}

void BroadPhase::mark_changed(std::uint32_t shape) {
  if (proxies_[shape].changed) return;
  proxies_[shape].changed = true;
  changed_.push_back(shape);
}

/// Adds the pairs of a shape that changed. Of two that changed the smaller one tells.
void BroadPhase::find_near(std::uint32_t shape) {
  const Proxy& proxy = proxies_[shape];
  if (proxy.place == Place::absent) return;
  const auto meets = [&](const Bounds& bounds) { return overlap(proxy.wide, bounds); };
  const auto add = [&](std::uint32_t other) {
    const Proxy& by = proxies_[other];
    if (other == shape || (by.changed && other < shape)) return;
    const bool own = proxy.owner != BoundsTree::none && proxy.owner == by.owner;
    own_ += own ? 1 : 0;
    if (!own && (proxy.moves || by.moves)) near_.push_back(std::minmax(shape, other));
    require_no_crowd(near_.size() + own_ / cheap, proxies_.size(), is_endless(proxy.exact) ? by.exact : proxy.exact);
  };
  moving_.visit(meets, add);
  if (proxy.moves || proxy.place == Place::endless) resting_.visit(meets, add);
  for (const std::uint32_t other : endless_)
    if (meets(proxies_[other].wide)) add(other);
}

void BroadPhase::update_near() {
  if (changed_.empty()) return;
  std::erase_if(near_, [&](const Pair& p) { return proxies_[p.first].changed || proxies_[p.second].changed; });
  own_ = 0;
  const auto kept = static_cast<std::ptrdiff_t>(near_.size());
  for (const std::uint32_t shape : changed_) find_near(shape);
  std::sort(near_.begin() + kept, near_.end());
  if (kept > 0) {
    added_.assign(near_.begin() + kept, near_.end());
    merge_from_back(near_, kept, added_);
  }
  for (const std::uint32_t shape : changed_) proxies_[shape].changed = false;
  changed_.clear();
}

std::span<const BroadPhase::Pair> BroadPhase::pairs() {
  update_near();
  pairs_.clear();
  for (const Pair& pair : near_)
    if (overlap(proxies_[pair.first].exact, proxies_[pair.second].exact)) pairs_.push_back(pair);
  return pairs_;
}

}  // namespace pantin
