#include "player/panels/layout.hpp"

#include <algorithm>

namespace pantin::player {

void lay_out(std::vector<Tile>& tiles, const Board& board) {
  struct Column {
    float left, right, free;
  };
  std::vector<Column> columns;
  float cascade = board.top;
  for (Tile& tile : tiles) {
    auto place = std::ranges::find_if(columns, [&](const Column& column) {
      return column.right - tile.width >= column.left && column.free + tile.height <= board.bottom;
    });
    if (place == columns.end()) {
      const float right = columns.empty() ? board.right : columns.back().left - board.gap;
      if (right - tile.width < board.left) {
        tile.x = std::max(board.right - tile.width, 0.0f);
        tile.y = cascade += board.title;
        continue;
      }
      columns.push_back({right - tile.width, right, board.top});
      place = columns.end() - 1;
    }
    tile.x = place->right - tile.width;
    tile.y = place->free;
    place->free += tile.height + board.gap;
  }
}

}  // namespace pantin::player
