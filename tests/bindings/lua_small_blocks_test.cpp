#include "lua/vm/small_blocks.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <vector>

using pantin::lua::SmallBlocks;

namespace {

struct Taken {
  unsigned char* block;
  std::size_t size;
  unsigned char mark;
};

bool is_marked(const Taken& t) {
  for (std::size_t i = 0; i < t.size; i++)
    if (t.block[i] != t.mark) return false;
  return true;
}

}  // namespace

TEST_CASE("small blocks of all sizes are apart from each other and aligned") {
  SmallBlocks blocks;
  std::vector<Taken> taken;
  for (int round = 0; round < 300; round++)  // more than one chunk of each size
    for (std::size_t size = 1; size <= SmallBlocks::most; size += 5) {
      auto* block = static_cast<unsigned char*>(blocks.take(size));
      REQUIRE(block != nullptr);
      REQUIRE(reinterpret_cast<std::uintptr_t>(block) % 16 == 0);
      taken.push_back({block, size, static_cast<unsigned char>(taken.size() % 251)});
      std::memset(block, taken.back().mark, size);
    }
  for (const Taken& t : taken) REQUIRE(is_marked(t));
}

TEST_CASE("a small block that was given back is taken again by what has its size") {
  SmallBlocks blocks;
  void* first = blocks.take(40);
  blocks.give_back(first, 40);
  CHECK(SmallBlocks::alike(40, 48));
  CHECK_FALSE(SmallBlocks::alike(48, 49));
  CHECK(blocks.take(49) != first);
  CHECK(blocks.take(48) == first);
}
