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

bool Layout::free_at(const Tile& tile, const Board& board) const {
  const float right = tile.x + tile.width, bottom = tile.y + tile.height;
  if (tile.x < board.edge || right > board.right || tile.y < board.top || bottom > board.bottom) return false;
  if (tile.x < board.left && tile.y < board.under) return false;
  return std::ranges::none_of(placed_, [&](const Tile* other) {
    return tile.x < other->x + other->width && other->x < right && tile.y < other->y + other->height &&
           other->y < bottom;
  });
}

/// Beside or below what is placed.
bool Layout::squeeze_in(Tile& tile, const Board& board) const {
  const auto try_at = [&](float x, float y) {
    const Tile wanted{x, y, tile.width, tile.height, tile.column};
    const bool free = free_at(wanted, board);
    if (free) tile = wanted;
    return free;
  };
  const auto try_row = [&](float y) {
    if (try_at(board.edge, y) || try_at(board.left, y)) return true;
    return std::ranges::any_of(placed_, [&](const Tile* other) {
      return try_at(other->x + other->width + board.gap, y) || try_at(other->x - board.gap - tile.width, y);
    });
  };
  if (try_row(board.top) || try_row(board.under)) return true;
  return std::ranges::any_of(placed_, [&](const Tile* other) { return try_row(other->y + other->height + board.gap); });
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
  placed_.clear();
  for (const Tile* tile : order_)
    if (tile->x >= board.left) placed_.push_back(tile);
  float y = board.top;
  for (Tile* tile : order_) {
    if (tile->x >= board.left) continue;
    if (squeeze_in(*tile, board)) {
      placed_.push_back(tile);
      continue;
    }
    tile->x = std::max(board.right - tile->width, 0.0f);
    tile->y = y += board.title;
  }
}

}  // namespace pantin::player
