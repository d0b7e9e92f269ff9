#pragma once
#include <cstddef>
#include <vector>

namespace pantin::player {

/// A panel's upper left corner and size [px].
struct Tile {
  float x = 0.0f, y = 0.0f, width = 0.0f, height = 0.0f;
  std::size_t column = 0;  ///< from the right edge, where the layout put it
};

/// Where panels may stand [px].
struct Board {
  float left = 0.0f, right = 0.0f, top = 0.0f, bottom = 0.0f, gap = 0.0f;
  float title = 0.0f;  ///< height of a panel's title
  float edge = left;   ///< of what stands left of `left`, that reaches down to `under`: below it there is room too
  float under = 0.0f;
};

/// Lays panels out in each frame, without asking for memory again.
class Layout {
 public:
  /// Sets the corners of tiles of given sizes: each goes into the first column that has room for it, from the right edge
  /// on, in their order, or the tallest first where that takes too many columns. Those that find no room even so stand
  /// where they cover none, if there is such a place; else in a cascade from the upper right corner, so that their titles
  /// show.
  void lay_out(std::vector<Tile>& tiles, const Board& board);

 private:
  struct Column {
    float width, free;  ///< [px], and where the next tile goes
    float right;        ///< [px] edge
  };
  bool fill(const Board& board);
  bool free_at(const Tile& tile, const Board& board) const;
  bool squeeze_in(Tile& tile, const Board& board) const;

  std::vector<Tile*> order_;
  std::vector<const Tile*> placed_;
  std::vector<Column> columns_;
};

}  // namespace pantin::player
