#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// A sparse matrix of 3 x 3 blocks with symmetric pattern and unsymmetric values, and its LDU factor in place. Rows are
/// numbered in the order of elimination; no interchanges.
struct Factor {
  std::uint32_t rows = 0;
  std::vector<std::uint32_t> first;   // (rows + 1) first block below the diagonal of each column
  std::vector<std::uint32_t> below;   // (blocks) row of each block below the diagonal, rising in a column
  std::vector<std::uint32_t> target;  // block, or row of the diagonal, that each update of the elimination reaches
  std::vector<Mat3> diagonal;         // (rows); inverted by `factorise`
  std::vector<Mat3> lower, upper;     // (blocks) entries (below[i], column) and (column, below[i])
  std::vector<Vec3> whole;            // (rows) sizes of the diagonal before the elimination
  std::vector<Mat3> scratch;          // (tallest column)

  static constexpr std::uint32_t on_diagonal = 0x80000000u,
                                 is_fill_in = 0x40000000u;  // flags of `target`; fill-in: the block is zeroed first
  static constexpr double weak = 1e-4;                      // of the diagonal

  /// Index of the block (row, column), row > column; it must be in the pattern.
  std::uint32_t block(std::uint32_t row, std::uint32_t column) const;
  /// Eliminates one column, all before it being done. `to` runs along `target`. A pivot below
  /// `redundant` of the whole is of a redundant row: its inverse is 0. Returns whether a pivot is weak.
  bool eliminate(std::uint32_t column, const std::uint32_t*& to, double redundant);
  /// The same where all is symmetric and no row redundant: `upper` need not be set. Pivots of one block may differ by 1e7 and more.
  void eliminate_symmetric(std::uint32_t column, const std::uint32_t*& to);
  /// The two sweeps of a solution in place, `y` (rows): columns rising, then columns falling.
  void substitute_forward(std::uint32_t column, Vec3* y) const;
  void substitute_back(std::uint32_t column, Vec3* y) const;

 private:
  /// From the blocks to come, of what is below a column in `scratch` times what is right of it in `upper`.
  template <bool symmetric>
  void subtract_products(std::uint32_t column, const std::uint32_t*& to);
};

/// Lists of rows, one after the other.
struct RowLists {
  std::vector<std::uint32_t> first;  // (lists + 1)
  std::vector<std::uint32_t> rows;

  std::span<const std::uint32_t> operator[](std::size_t k) const {
    return {rows.data() + first[k], first[k + 1] - first[k]};
  }
};

}  // namespace pantin
