#pragma once
// Places sorted into the cells of a grid that holds occupied cells only, so that its size is bounded by their number.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Cells half a reach wide. Their axes are those of space by falling extent, but for the last two: layers along the
/// longest, lines of cells along the second, which are contiguous in memory.
struct Grid {
  static constexpr std::int32_t around = 2;  ///< a site's neighbours are at most so many cells away, along each axis
  enum Axis { of_layer, of_row, of_line };

  std::array<std::size_t, 3> axis{};        ///< of space: 0, 1, 2
  std::array<double, 3> origin{};           ///< [m]
  std::array<double, 3> cells_per_metre{};  ///< [1/m]
  std::array<std::int32_t, 3> cells{};
  double extent = 0.0;  ///< [m] the longest
  bool periodic = false;
  bool narrow = true;  ///< all sites of a cell are within reach of each other

  std::int32_t cell(std::size_t k, Vec3 x) const;
};

/// Throws Error where a position is not finite, or in a box not within it.
Grid make_grid(std::span<const Vec3> positions, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
               const Box& box, double reach);

/// Some sites in the order of their cells.
struct Cells {
  struct Cell {
    std::uint32_t begin = 0;  ///< first site
    std::int32_t at = 0;      ///< along its line
  };
  struct Line {
    std::int32_t layer = 0, row = 0;
    std::uint32_t begin = 0;  ///< first cell
  };

  std::vector<std::uint32_t> site;  ///< and some values more, as in x, y, z: blocks of them may be read past the end
  AlignedVector<double> x, y, z;    ///< [m]
  std::vector<Cell> cells;          ///< occupied ones, and an end
  std::vector<Line> lines;          ///< likewise
  std::size_t n = 0;

  void fill(const Grid& grid, std::span<const Vec3> positions, std::span<const std::uint32_t> members);
  /// Whether the grid has so few cells that each, occupied or not, has a number.
  bool is_dense() const { return !starts_.empty(); }
  /// First site of such a grid's cell, occupied or not, of a line; of the cell after the line's last, the end.
  std::uint32_t begin_of(std::size_t line, std::int32_t at) const {
    return starts_[line_starts_[line] + static_cast<std::size_t>(at)];
  }
  /// Index of the line, or -1.
  std::ptrdiff_t find_line(std::int32_t layer, std::int32_t row) const;

 private:
  struct Key {
    std::int32_t layer, row, at;
    std::uint32_t site;
  };
  void sort(const Grid& grid, std::span<const Vec3> positions, std::span<const std::uint32_t> members);
  static std::size_t number_of(const Key& key, const Grid& grid);  // of a cell of a dense grid
  void find_cells(const Grid& grid);
  void copy_positions(std::span<const Vec3> positions);

  std::vector<Key> keys_, sorted_;
  std::vector<std::uint32_t> starts_;     // of all cells of a dense grid, with an end; else empty
  std::vector<std::size_t> line_starts_;  // (lines) in `starts_`
};

/// The order of positions by cells of the given width [m]: element k is the site to be put at k.
std::vector<std::uint32_t> cell_order(std::span<const Vec3> positions, const Box& box, double width);

}  // namespace pantin
