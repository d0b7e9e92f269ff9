#pragma once
#include <algorithm>
#include <optional>

#include "articulates/articulate.hpp"
#include "articulates/fetch.hpp"
#include "base/parallel.hpp"
#include "world/share_blocks.hpp"

namespace pantin::phases {

/// Calls f(articulate, worker) for each, among the world's threads where there is enough to do. What f does must concern its
/// articulate, and the model's rows of that articulate's things, only. With `fetches` f solves it, and asks for the memory of
/// the next one meanwhile, where that is more than a cache holds.
template <class F>
void share_articulates(World& world, F&& f, bool fetches = false) {
  constexpr std::size_t enough_rows = 64;    // some 20 us of work: a thread is slow to wake
  constexpr std::size_t cached_rows = 2000;  // whose memory, some 3 kB a row, a cache holds
  std::size_t rows = 0;
  for (const auto& articulate : world.articulates) rows += articulate->rest.asleep ? 0 : articulate->rows.size();
  const std::size_t count = world.articulates.size();
  const std::size_t enough = rows < 2 * enough_rows ? count : std::max<std::size_t>(1, count * enough_rows / rows);
  share_blocks(world, count, std::max<std::size_t>(1, enough), [&](std::size_t first, std::size_t last, int worker) {
    for (std::size_t i = first; i < last; i++) {
      std::optional<Fetch> fetch;
      if (fetches && rows > cached_rows && i + 1 < last && !world.articulates[i + 1]->rest.asleep)
        fetch.emplace(*world.articulates[i + 1]);
      f(*world.articulates[i], worker);
    }
  });
}

}  // namespace pantin::phases
