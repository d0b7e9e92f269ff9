#pragma once
// Finding the neighbours of the sites of one line of cells after the other.
#include <cstdint>
#include <utility>
#include <vector>

#include "base/aligned.hpp"
#include "laws/run/cells.hpp"
#include "laws/run/neighbours.hpp"

namespace pantin {

/// Which pairs are left out.
struct Omitted {
  const Sites& sites;
  const Exclusions& further;

  bool has(std::uint32_t i) const;  ///< any with site i
  /// Takes those out of [begin, end) that site i does not interact with; gives the new end.
  std::uint32_t* remove(std::uint32_t i, std::uint32_t* begin, std::uint32_t* end) const;
};

/// Ends a row of the slab: `count` neighbours from `begin`, filled up with the dummy.
void close_row(Slab& slab, std::uint32_t site, std::size_t begin, std::size_t count, std::size_t shift,
               std::uint32_t dummy);

/// Writes the rows of a few lines of cells.
class Scanner {
 public:
  Scanner(const Omitted& omitted, const Grid& grid, const Cells& a, const Cells& b, bool within, double reach,
          const Vec3* shifts)
      : omitted_(omitted), grid_(grid), a_(a), b_(b), within_(within), reach2_(reach * reach), shifts_(shifts) {}

  /// Adds the rows of a line of `a`; gives the number of pairs, or one more than NeighbourList::most_pairs when they are more.
  std::uint64_t add_line(Slab& slab, std::size_t line);

 private:
  /// The neighbour cells of a line, seen at one shift along it.
  struct Piece {
    std::size_t shift = 0, line = 0;
    std::uint32_t low = 0, high = 0, end = 0;  ///< cells, which move on as the line is gone along
    std::int32_t turns = 0;                    ///< boxes, along the line
    bool self = false;
  };

  /// Up to four of `b`, one after the other in its order.
  struct Four {
    std::uint32_t begin = 0, lanes = 0;  ///< a bit for each
  };

  /// What of `b` the sites of a cell look at, at one shift.
  struct View {
    std::size_t shift = 0;
    std::size_t begin = 0, end = 0;  ///< of `fours_`
    std::uint32_t self_end = 0;      ///< and each site at what comes after it, up to here
  };

  void find_pieces(const Cells::Line& line);
  void add_pieces(std::int32_t layer, std::int32_t row, std::size_t shift, bool self);
  void move_on(std::int32_t at);
  /// First and end of the sites of a piece in the cells [from, to] along it, one of which at least is in the grid.
  std::pair<std::uint32_t, std::uint32_t> find_range(Piece& piece, std::int32_t from, std::int32_t to) const;
  void add_fours(std::uint32_t begin, std::uint32_t end);
  std::uint64_t add_site(Slab& slab, std::uint32_t k);
  std::size_t stride(Grid::Axis k) const { return grid_.axis[k] == 0 ? 1 : grid_.axis[k] == 1 ? 3 : 9; }

  Omitted omitted_;
  const Grid& grid_;
  const Cells &a_, &b_;
  bool within_;
  double reach2_;
  const Vec3* shifts_;
  std::vector<Piece> pieces_;
  std::vector<View> views_;  ///< not empty, in the order of the pieces
  AlignedVector<Four> fours_;
};

}  // namespace pantin
