#include "player/panels/layout.hpp"

#include <algorithm>
#include <functional>

namespace pantin::player {
namespace {

struct PanelColumn {
  float width, free;  ///< [px], and where the next tile goes
  std::vector<Tile*> tiles;
};

/// Fills columns from the right; returns those that have no room.
std::vector<Tile*> fill(const std::vector<Tile*>& tiles, const Board& board) {
  std::vector<PanelColumn> columns;
  for (Tile* tile : tiles) {
    auto column =
        std::ranges::find_if(columns, [&](const PanelColumn& c) { return c.free + tile->height <= board.bottom; });
    if (column == columns.end()) column = columns.insert(column, {0.0f, board.top, {}});
    column->width = std::max(column->width, tile->width);
    tile->y = column->free;
    column->free += tile->height + board.gap;
    column->tiles.push_back(tile);
  }
  std::vector<Tile*> left_over;
  float right = board.right;
  for (const PanelColumn& column : columns) {
    for (Tile* tile : column.tiles) {
      tile->x = right - tile->width;
      if (tile->x < board.left) left_over.push_back(tile);
    }
    right -= column.width + board.gap;
  }
  return left_over;
}

}  // namespace

void lay_out(std::vector<Tile>& tiles, const Board& board) {
  std::vector<Tile*> order;
  for (Tile& tile : tiles) order.push_back(&tile);
  std::vector<Tile*> left_over = fill(order, board);
  if (left_over.empty()) return;
  std::ranges::stable_sort(order, std::ranges::greater(), &Tile::height);  // takes fewer columns
  left_over = fill(order, board);
  float y = board.top;
  for (Tile* tile : left_over) {
    tile->x = std::max(board.right - tile->width, 0.0f);
    tile->y = y += board.title;
  }
}

}  // namespace pantin::player
