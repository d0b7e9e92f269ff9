#include "contacts/manifold_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace pantin {

namespace {

constexpr std::uint32_t most_kept = 4;

/// Parts of lengths and areas within which those are held for equal.
constexpr double same_extent = 1e-6;

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

using Order = std::span<const std::uint32_t>;
using Points = std::span<const ManifoldPoint>;

/// The first that is as deep as the deepest.
std::uint32_t deepest(Points points, Order order, double reach) {
  const double least = least_gap(points);
  for (const std::uint32_t i : order)
    if (points[i].gap <= least + same_gap * reach) return i;
  return order[0];
}

/// By their ids.
Order in_order(Points points) {
  thread_local std::vector<std::uint32_t> order;
  order.resize(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](std::uint32_t i, std::uint32_t j) {
    return points[i].id != points[j].id ? points[i].id < points[j].id : i < j;
  };
  if (!std::is_sorted(order.begin(), order.end(), before)) std::sort(order.begin(), order.end(), before);
  return order;
}

}  // namespace

double least_gap(Points points) {
  double least = infinity;
  for (const ManifoldPoint& p : points) least = std::fmin(least, p.gap);
  return least;
}

void keep_points(Points points, double reach, double turn_way, Manifold& manifold) {
  if (points.size() <= most_kept) {
    for (const ManifoldPoint& p : points) append(manifold, p);
    return;
  }
  const Order order = in_order(points);
  const double least_extent = same_extent * reach;
  const ManifoldPoint& first = points[deepest(points, order, reach)];
  // What is open counts less, lest an edge that touches gives way to a corner that is farther and open.
  const double low = half_as_low * reach + turn_way;
  const auto counts = [&](const ManifoldPoint& point) {
    return 1.0 / (1.0 + std::fmax(0.0, point.gap - first.gap - as_low * reach) / low);
  };
  Choice far(least_extent * least_extent);
  for (const std::uint32_t i : order) far.offer(i, norm2(points[i].on_a - first.on_a) * counts(points[i]));
  append(manifold, first);
  if (far.chosen() == Choice::none) return;

  const ManifoldPoint& second = points[far.chosen()];
  append(manifold, second);
  const Vec3 across = cross(first.normal, second.on_a - first.on_a);
  Choice left(least_extent * norm(across)), right(least_extent * norm(across));
  for (const std::uint32_t i : order) {
    const double side = dot(across, points[i].on_a - first.on_a) * counts(points[i]);
    left.offer(i, side);
    right.offer(i, -side);
  }
  for (const std::uint32_t chosen : {left.chosen(), right.chosen()})
    if (chosen != Choice::none) append(manifold, points[chosen]);
}

}  // namespace pantin
