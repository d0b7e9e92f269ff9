#include "contacts/manifold_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pantin {

namespace {

constexpr std::uint32_t most_kept = 4;

/// Parts of the reach within which gaps, and parts of lengths and areas within which those, are held for equal.
constexpr double same_gap = 1e-9, same_extent = 1e-6;
/// Parts of the reach: how much higher than the lowest a point may be that counts in full, and that counts by half.
constexpr double as_low = 1e-5, half_as_low = 1e-3;

void append(Manifold& manifold, ManifoldPoint point) {
  const auto end = manifold.points.begin() + manifold.count;
  const auto has_id = [&](const ManifoldPoint& other) { return other.id == point.id; };
  while (std::any_of(manifold.points.begin(), end, has_id)) point.id++;
  manifold.points[manifold.count++] = point;
}

/// Chooses among points by what grows with their worth.
class Choice {
 public:
  explicit Choice(double least) : best_(least) {}
  void offer(std::uint32_t index, double worth) {
    if (worth > best_ * (1.0 + same_extent)) {
      best_ = worth;
      chosen_ = index;
    }
  }
  static constexpr std::uint32_t none = ~0u;
  std::uint32_t chosen() const { return chosen_; }

 private:
  double best_;
  std::uint32_t chosen_ = none;
};

using Order = std::array<std::uint32_t, PointList::capacity>;

/// The first that is as deep as the deepest.
std::uint32_t deepest(const PointList& list, const Order& order, double reach) {
  const double least = least_gap(list);
  for (std::uint32_t i = 0; i < list.count; i++)
    if (list.points[order[i]].gap <= least + same_gap * reach) return order[i];
  return order[0];
}

}  // namespace

double least_gap(const PointList& list) {
  double least = infinity;
  for (std::uint32_t i = 0; i < list.count; i++) least = std::fmin(least, list.points[i].gap);
  return least;
}

void keep_points(const PointList& list, double reach, double turn_way, Manifold& manifold) {
  if (list.count <= most_kept) {
    for (std::uint32_t i = 0; i < list.count; i++) append(manifold, list.points[i]);
    return;
  }
  Order order;
  const auto end = order.begin() + list.count;
  std::iota(order.begin(), end, 0u);
  std::sort(order.begin(), end, [&](std::uint32_t i, std::uint32_t j) {
    return list.points[i].id != list.points[j].id ? list.points[i].id < list.points[j].id : i < j;
  });

  const double least_extent = same_extent * reach;
  const ManifoldPoint& first = list.points[deepest(list, order, reach)];
  // What is open counts less, lest an edge that touches gives way to a corner that is farther and open.
  const double low = half_as_low * reach + turn_way;
  const auto counts = [&](const ManifoldPoint& point) {
    return 1.0 / (1.0 + std::fmax(0.0, point.gap - first.gap - as_low * reach) / low);
  };
  Choice far(least_extent * least_extent);
  for (auto i = order.begin(); i != end; ++i)
    far.offer(*i, norm2(list.points[*i].on_a - first.on_a) * counts(list.points[*i]));
  append(manifold, first);
  if (far.chosen() == Choice::none) return;

  const ManifoldPoint& second = list.points[far.chosen()];
  append(manifold, second);
  const Vec3 across = cross(first.normal, second.on_a - first.on_a);
  Choice left(least_extent * norm(across)), right(least_extent * norm(across));
  for (auto i = order.begin(); i != end; ++i) {
    const double side = dot(across, list.points[*i].on_a - first.on_a) * counts(list.points[*i]);
    left.offer(*i, side);
    right.offer(*i, -side);
  }
  for (const std::uint32_t chosen : {left.chosen(), right.chosen()})
    if (chosen != Choice::none) append(manifold, list.points[chosen]);
}

}  // namespace pantin
