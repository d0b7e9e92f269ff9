#include <catch2/catch.hpp>

#include "player/panels/layout.hpp"

using namespace pantin::player;

namespace {

bool meet(const Tile& a, const Tile& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

TEST_CASE("layout: no panel covers another or leaves the board, where there is room") {
  const Board board{220, 1270, 50, 640, 8, 20};
  std::vector<Tile> tiles;
  for (const auto& [width, height] :
       {std::pair(420.0f, 118.0f), {380.0f, 167.0f}, {300.0f, 182.0f}, {300.0f, 264.0f}, {320.0f, 350.0f}})
    tiles.push_back({0, 0, width, height});
  Layout().lay_out(tiles, board);
  for (std::size_t i = 0; i < tiles.size(); i++) {
    CHECK(tiles[i].x >= board.left);
    CHECK(tiles[i].x + tiles[i].width <= board.right);
    CHECK(tiles[i].y + tiles[i].height <= board.bottom);
    for (std::size_t k = 0; k < i; k++) CHECK_FALSE(meet(tiles[i], tiles[k]));
  }
}

TEST_CASE("layout: panels stand in their order where that fits") {
  std::vector<Tile> tiles = {{0, 0, 420, 100}, {0, 0, 380, 200}};
  Layout().lay_out(tiles, {220, 1270, 50, 640, 8, 20});
  CHECK(tiles[0].x == 850);
  CHECK(tiles[0].y == 50);
  CHECK(tiles[1].x == 890);
  CHECK(tiles[1].y == 158);
}

TEST_CASE("layout: what finds no room in a column stands under what is at the left, where it covers none") {
  Board board{220, 790, 50, 480, 8, 20};
  board.edge = 10;
  board.under = 230;
  std::vector<Tile> tiles = {{0, 0, 300, 260}, {0, 0, 380, 160}, {0, 0, 380, 56}};
  Layout().lay_out(tiles, board);
  for (std::size_t i = 0; i < tiles.size(); i++) {
    CHECK((tiles[i].x >= board.left || tiles[i].y >= board.under));
    CHECK((tiles[i].x >= board.edge && tiles[i].x + tiles[i].width <= board.right));
    CHECK(tiles[i].y + tiles[i].height <= board.bottom);
    for (std::size_t k = 0; k < i; k++) CHECK_FALSE(meet(tiles[i], tiles[k]));
  }
}

TEST_CASE("layout: what finds no room shows its title, clear of the left edge and of the other titles") {
  const Board board{220, 780, 50, 400, 8, 20};
  std::vector<Tile> tiles(4, Tile{0, 0, 400, 300});
  Layout().lay_out(tiles, board);
  for (std::size_t i = 0; i < tiles.size(); i++) {
    CHECK(tiles[i].x >= board.left);
    for (std::size_t k = 0; k < i; k++) CHECK(tiles[i].y >= tiles[k].y + board.title);
  }
}
