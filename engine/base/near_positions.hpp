#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/interruptible.hpp"
#include "base/lanes.hpp"

namespace pantin {

/// Finds which of many positions are within a radius [m] of another, by cells of that size. For one thread at a time.
class NearPositions {
 public:
  NearPositions(std::span<const Vec3> positions, double radius) : positions_(positions), radius_(radius) {
    double extent = 0.0;
    for (Vec3 p : positions) extent = std::fmax(extent, largest(p));
    cell_ = std::fmax(radius, std::fmax(extent * 1e-9, 1e-300));
    for (std::uint32_t i = 0; i < positions.size(); i++) sorted_.push_back({cell_of(positions[i]), i});
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// Calls `visit(number)` for each position within the radius.
  template <class Visit>
  void each(Vec3 at, const Visit& visit) const {
    each_until(at, [&](std::uint32_t number) {
      visit(number);
      return false;
    });
  }
  /// The lowest number of a position within the radius, where there is one.
  std::optional<std::uint32_t> lowest(Vec3 at) const {
    std::optional<std::uint32_t> least;
    each_until(at, [&](std::uint32_t number) {
      least = std::min(least.value_or(number), number);
      return true;
    });
    return least;
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
    auto operator<=>(const Cell&) const = default;
  };
  /// Calls `visit(number)` for positions within the radius, of each cell in rising order until it returns true.
  template <class Visit>
  void each_until(Vec3 at, const Visit& visit) const {
    const Cell centre = cell_of(at);
    for (std::int64_t dx = -1; dx <= 1; dx++)
      for (std::int64_t dy = -1; dy <= 1; dy++)
        for (std::int64_t dz = -1; dz <= 1; dz++) {
          const Cell cell{centre.x + dx, centre.y + dy, centre.z + dz};
          auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{cell, std::uint32_t{0}});
          for (loop_.count(); it != sorted_.end() && it->first == cell; ++it, loop_.count())
            if (norm(positions_[it->second] - at) <= radius_ && visit(it->second)) break;
        }
  }
  Cell cell_of(Vec3 p) const {
    const auto index = [&](double v) {
      return static_cast<std::int64_t>(std::fmax(-1e15, std::fmin(1e15, std::floor(v / cell_))));
    };
    return {index(p[0]), index(p[1]), index(p[2])};
  }

  std::span<const Vec3> positions_;
  double radius_, cell_ = 0.0;
  std::vector<std::pair<Cell, std::uint32_t>> sorted_;
  mutable Interruptible loop_;
};

}  // namespace pantin
