#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// Finds which of many positions are within a radius [m] of another, by cells of that size.
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
    const Cell centre = cell_of(at);
    for (std::int64_t dx = -1; dx <= 1; dx++)
      for (std::int64_t dy = -1; dy <= 1; dy++)
        for (std::int64_t dz = -1; dz <= 1; dz++) {
          const Cell cell{centre.x + dx, centre.y + dy, centre.z + dz};
          auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{cell, std::uint32_t{0}});
          for (; it != sorted_.end() && it->first == cell; ++it)
            if (norm(positions_[it->second] - at) <= radius_) visit(it->second);
        }
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
    auto operator<=>(const Cell&) const = default;
  };
  Cell cell_of(Vec3 p) const {
    const auto index = [&](double v) {
      return static_cast<std::int64_t>(std::fmax(-1e15, std::fmin(1e15, std::floor(v / cell_))));
    };
    return {index(p[0]), index(p[1]), index(p[2])};
  }

  std::span<const Vec3> positions_;
  double radius_, cell_ = 0.0;
  std::vector<std::pair<Cell, std::uint32_t>> sorted_;
};

}  // namespace pantin
