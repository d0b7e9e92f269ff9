#pragma once
#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/subnormals.hpp"
#include "world/world.hpp"

namespace pantin {

/// Calls f(first, last, worker) for blocks of `count` things, among the world's threads; a thread takes at least `enough` of them.
template <class F>
void share_blocks(const World& world, std::size_t count, std::size_t enough, F&& f) {
  if (count == 0) return;
  constexpr std::size_t most_blocks = 64;
  const std::size_t blocks = world.workers->count() == 1 ? 1 : std::clamp<std::size_t>(count / enough, 1, most_blocks);
  world.workers->run(blocks, [&](std::size_t block, int worker) {
    const SubnormalsAreZero subnormals_are_zero;
    f(count * block / blocks, count * (block + 1) / blocks, worker);
  });
}

/// Calls f(i) for each of `count` things of which nothing but a few numbers is read and written, among the world's threads.
template <class F>
void share_each(const World& world, std::size_t count, F&& f) {
  share_blocks(world, count, 4096, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; i++) f(i);
  });
}

}  // namespace pantin
