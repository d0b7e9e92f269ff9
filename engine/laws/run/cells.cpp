#include "laws/run/cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/bounds.hpp"
#include "base/check.hpp"

namespace pantin {

namespace {

constexpr double most_cells = 1 << 30;  // along an axis

Bounds bounds_of(std::span<const Vec3> positions, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  Bounds bounds;
  double all = 0.0;  // not finite when one of them is not
  for (const auto& members : {a, b})
    for (const std::uint32_t i : members) {
      const Vec3 x = positions[i];
      bounds.add(x);
      all += (x[0] + x[1] + x[2]) * 0.0;
    }
  require(all == 0.0, "a particle is at a position that is not finite: its neighbours cannot be found");
  return bounds;
}

void require_inside(const Bounds& bounds, const Box& box) {
  for (int k = 0; k < 3; k++)
    require(
        bounds.low[k] >= 0.0 && bounds.high[k] <= box.edge[k],
        "a particle is too far out of the periodic box to be followed: forces or speeds are too large for this step");
}

}  // namespace

std::int32_t Grid::cell(std::size_t k, Vec3 x) const {
  const double at = (x[axis[k]] - origin[k]) * cells_per_metre[k];
  return std::clamp(static_cast<std::int32_t>(at), 0, cells[k] - 1);
}

Grid make_grid(std::span<const Vec3> positions, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
               const Box& box, double reach) {
  Grid grid;
  if (a.empty() && b.empty()) return grid;
  const Bounds bounds = bounds_of(positions, a, b);
  grid.periodic = box.periodic();
  if (grid.periodic) require_inside(bounds, box);
  const Vec3 extent = grid.periodic ? box.edge : bounds.high - bounds.low;
  std::array<std::size_t, 3> axis{2, 1, 0};
  std::sort(axis.begin(), axis.end(),
            [&](std::size_t k, std::size_t l) { return std::pair(extent[k], k) > std::pair(extent[l], l); });
  grid.axis = {axis[0], axis[2], axis[1]};
  grid.extent = extent[axis[0]];
  // A little wider than half the reach, so that rounding takes nobody out of reach.
  const double least_width = 0.5 * reach * (1.0 + 1e-9);
  for (std::size_t k = 0; k < 3; k++) {
    const double length = extent[grid.axis[k]], wanted = std::floor(length / least_width);
    const double count = std::clamp(grid.periodic ? wanted : wanted + 1.0, 1.0, most_cells);
    grid.narrow = grid.narrow && wanted < most_cells && (!grid.periodic || length / count < 0.57 * reach);
    grid.cells[k] = static_cast<std::int32_t>(count);
    grid.origin[k] = grid.periodic ? 0.0 : bounds.low[grid.axis[k]];
    const bool by_length = grid.periodic || wanted >= most_cells;
    grid.cells_per_metre[k] = by_length && length > 0.0 ? count / length : 1.0 / least_width;
  }
  return grid;
}

void Cells::fill(const Grid& grid, std::span<const Vec3> positions, std::span<const std::uint32_t> members) {
  n = members.size();
  sort(grid, positions, members);
  find_cells(grid);
  copy_positions(positions);
}

void Cells::sort(const Grid& grid, std::span<const Vec3> positions, std::span<const std::uint32_t> members) {
  keys_.resize(n);
  for (std::size_t k = 0; k < n; k++) {
    const Vec3 position = positions[members[k]];
    keys_[k] = {grid.cell(Grid::of_layer, position), grid.cell(Grid::of_row, position),
                grid.cell(Grid::of_line, position), members[k]};
  }
  starts_.clear();
  const double numbers = static_cast<double>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
  if (numbers > 4.0 * static_cast<double>(n) + 4096.0) {
    std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
      return std::tie(a.layer, a.row, a.at, a.site) < std::tie(b.layer, b.row, b.at, b.site);
    });
    return;
  }
  // The count of a cell is put two places after it, so that at last its end is at the next.
  starts_.assign(static_cast<std::size_t>(numbers) + 2, 0);
  for (const Key& key : keys_) starts_[number_of(key, grid) + 2]++;
  for (std::size_t c = 2; c < starts_.size(); c++) starts_[c] += starts_[c - 1];
  sorted_.resize(n);
  for (const Key& key : keys_) sorted_[starts_[number_of(key, grid) + 1]++] = key;
  keys_.swap(sorted_);
}

std::size_t Cells::number_of(const Key& key, const Grid& grid) {
  return static_cast<std::size_t>((key.layer * grid.cells[Grid::of_row] + key.row) * grid.cells[Grid::of_line] +
                                  key.at);
}

void Cells::find_cells(const Grid& grid) {
  cells.clear();
  lines.clear();
  line_starts_.clear();
  for (std::size_t k = 0; k < n; k++) {
    const Key& key = keys_[k];
    const bool new_line = k == 0 || key.layer != keys_[k - 1].layer || key.row != keys_[k - 1].row;
    if (new_line) {
      lines.push_back({key.layer, key.row, static_cast<std::uint32_t>(cells.size())});
      if (is_dense()) line_starts_.push_back(number_of({key.layer, key.row, 0, 0}, grid));
    }
    if (new_line || key.at != keys_[k - 1].at) cells.push_back({static_cast<std::uint32_t>(k), key.at});
  }
  lines.push_back({0, 0, static_cast<std::uint32_t>(cells.size())});
  cells.push_back({static_cast<std::uint32_t>(n), 0});
}

void Cells::copy_positions(std::span<const Vec3> positions) {
  site.resize(n + Sites::padding);
  for (AlignedVector<double>* column : {&x, &y, &z}) {
    column->resize(n + Sites::padding);
    std::fill(column->begin() + n, column->end(), 0.0);
  }
  for (std::size_t k = 0; k < n; k++) {
    site[k] = keys_[k].site;
    const Vec3 position = positions[site[k]];
    x[k] = position[0];
    y[k] = position[1];
    z[k] = position[2];
  }
}

std::ptrdiff_t Cells::find_line(std::int32_t layer, std::int32_t row) const {
  const auto end = lines.end() - 1;
  const auto found = std::lower_bound(lines.begin(), end, std::tie(layer, row), [](const Line& line, const auto& key) {
    return std::tie(line.layer, line.row) < key;
  });
  return found != end && found->layer == layer && found->row == row ? found - lines.begin() : -1;
}

std::vector<std::uint32_t> cell_order(std::span<const Vec3> positions, const Box& box, double width) {
  std::vector<std::uint32_t> members(positions.size());
  std::iota(members.begin(), members.end(), 0u);
  Cells cells;
  cells.fill(make_grid(positions, members, {}, box, 2.0 * width), positions, members);
  cells.site.resize(positions.size());
  return std::move(cells.site);
}

}  // namespace pantin
