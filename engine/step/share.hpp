#pragma once
#include <algorithm>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "world/share_blocks.hpp"

namespace pantin::phases {

/// Calls f(articulate, worker) for each, among the world's threads where there is enough to do. What f does must concern its
/// articulate, and the model's rows of that articulate's things, only.
template <class F>
void share_articulates(World& world, F&& f) {
  constexpr std::size_t enough_rows = 64;  // some 20 us of work: a thread is slow to wake
  std::size_t rows = 0;
  if (world.workers->count() > 1)
    for (const auto& articulate : world.articulates) rows += articulate->rest.asleep ? 0 : articulate->rows.size();
  const std::size_t count = world.articulates.size();
  const std::size_t enough = rows < 2 * enough_rows ? count : std::max<std::size_t>(1, count * enough_rows / rows);
  share_blocks(world, count, std::max<std::size_t>(1, enough), [&](std::size_t first, std::size_t last, int worker) {
    for (std::size_t i = first; i < last; i++) f(*world.articulates[i], worker);
  });
}

}  // namespace pantin::phases
