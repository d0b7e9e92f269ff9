#include "lua/vm/small_blocks.hpp"

#include <cstdlib>

namespace pantin::lua {

SmallBlocks::~SmallBlocks() {
  while (chunks_) std::free(std::exchange(chunks_, chunks_->next));
}

bool SmallBlocks::refill(std::size_t place) {
  auto* memory = static_cast<std::byte*>(std::malloc(chunk));
  if (!memory) return false;
  chunks_ = new (memory) Link{chunks_};
  const std::size_t size = (place + 1) * grain;
  for (std::size_t at = grain + (chunk - grain) / size * size; at > grain; at -= size)
    give_back(memory + at - size, size);
  return true;
}

}  // namespace pantin::lua
