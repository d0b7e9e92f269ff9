#include "player/panels/layout.hpp"

#include <algorithm>
#include <utility>

namespace pantin::player {

/// Fills columns from the right; false where some have no room.
bool Layout::fill(const Board& board) {
  columns_.clear();
  for (Tile* tile : order_) {
    auto column =
        std::ranges::find_if(columns_, [&](const Column& c) { return c.free + tile->height <= board.bottom; });
    if (column == columns_.end()) column = columns_.insert(column, {0.0f, board.top, 0.0f});
    column->width = std::max(column->width, tile->width);
    tile->y = column->free;
    column->free += tile->height + board.gap;
    tile->column = static_cast<std::size_t>(column - columns_.begin());
  }
  float right = board.right;
  for (Column& column : columns_) {
    column.right = right;
    right -= column.width + board.gap;
  }
  for (Tile* tile : order_) tile->x = columns_[tile->column].right - tile->width;
  return std::ranges::all_of(order_, [&](const Tile* tile) { return tile->x >= board.left; });
}

void Layout::lay_out(std::vector<Tile>& tiles, const Board& board) {
  order_.clear();
  for (Tile& tile : tiles) order_.push_back(&tile);
  if (fill(board)) return;
  std::ranges::sort(order_, [](const Tile* a, const Tile* b) {  // takes fewer columns
    return a->height > b->height || (a->height == b->height && a < b);
  });
  fill(board);
  std::ranges::sort(order_, {}, [](const Tile* t) { return std::pair(t->column, t->y); });
  float y = board.top;
  for (Tile* tile : order_) {
    if (tile->x >= board.left) continue;
    tile->x = std::max(board.right - tile->width, 0.0f);
    tile->y = y += board.title;
  }
}

}  // namespace pantin::player
