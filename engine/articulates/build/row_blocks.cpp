#include <algorithm>
#include <span>

#include "articulates/build/build.hpp"
#include "articulates/solve/couplings.hpp"

namespace pantin {

void find_row_blocks(Articulate& a) {
  a.rows_on = rows_of_nodes(a.nodes.size(), a.rows);
  std::vector<char> reached(a.factor.below.size(), 0), meets_at_variables(a.nodes.size(), 0);
  for (const Hub& hub : a.hubs) meets_at_variables[hub.node] = 1;
  const auto free_of_hubs = [&](std::int32_t n) { return n >= 0 && !meets_at_variables[static_cast<std::size_t>(n)]; };
  for (Hub& hub : a.hubs) {
    for (std::uint32_t k : a.rows_on[hub.node]) {
      if (!free_of_hubs(a.rows[k].a) && !free_of_hubs(a.rows[k].b)) hub.only_on_hubs.push_back(k);
      hub.blocks.push_back(a.factor.block(hub.variable, k));
      reached[hub.blocks.back()] = 1;
      if (a.nodes[hub.node].is_body) reached[hub.blocks.back() + 1] = 1;
    }
  }
  a.first_row_block.assign(1, 0);
  for (std::uint32_t n = 0; n < a.nodes.size(); n++) {
    for (std::uint32_t i : meets_at_variables[n] ? std::span<const std::uint32_t>() : a.rows_on[n])
      for (std::uint32_t j : a.rows_on[n]) {
        if (i < j) continue;
        const std::uint32_t block = i == j ? i : a.factor.block(i, j);
        a.row_blocks.push_back({block, false, false});
        if (i != j) reached[block] = 1;
      }
    a.first_row_block.push_back(static_cast<std::uint32_t>(a.row_blocks.size()));
  }
  find_couplings(a);
  for (Coupling& coupling : a.couplings) {
    const auto clear = [&](std::uint32_t block) {
      if (reached[block]) return;
      reached[block] = 1;
      coupling.cleared.push_back(block);
    };
    for (const CoupledBlock& m : coupling.blocks)
      if (m.column != coupling.head) clear(m.block);
    for (const HeadBlock& m : coupling.head_blocks) clear(m.block);
  }
  for (std::uint32_t& t : a.factor.target) {
    if (t & Factor::on_diagonal || reached[t]) continue;
    reached[t] = 1;
    t |= Factor::is_fill_in;
  }
}

void find_tiles(Articulate& a) {
  constexpr std::uint32_t tile_rows = 8;
  const auto rows = static_cast<std::uint32_t>(a.rows.size()), batches = static_cast<std::uint32_t>(a.batches.size());
  std::vector<std::uint32_t> last_row(batches, 0), last_batch(rows, 0);
  for (std::uint32_t k = 0; k < rows; k++)
    for (std::int32_t n : {a.rows[k].a, a.rows[k].b}) {
      if (n < 0) continue;
      const auto batch = static_cast<std::uint32_t>(n) / static_cast<std::uint32_t>(batch_size);
      last_row[batch] = k;
      last_batch[k] = std::max(last_batch[k], batch);
    }
  for (const Coupling& coupling : a.couplings)
    for (std::uint32_t k : coupling.rows)
      last_batch[coupling.head] = std::max(last_batch[coupling.head], last_batch[k]);
  // Of rows; the variables of hubs come after them and wait for nothing.
  const auto last_below = [&](std::uint32_t column) {
    std::uint32_t i = a.factor.first[column + 1];
    while (i > a.factor.first[column] && a.factor.below[i - 1] >= rows) i--;
    return i > a.factor.first[column] ? a.factor.below[i - 1] : 0;
  };
  Tile w;
  while (w.forces < rows) {
    w.forces = std::min(rows, w.forces + tile_rows);
    while (w.batches < batches && last_row[w.batches] < w.forces) w.batches++;
    while (w.rows < rows && last_batch[w.rows] < w.batches) w.rows++;
    while (w.columns < w.rows && last_below(w.columns) < w.rows) w.columns++;
    if (w.columns == rows) w.columns = a.factor.rows;
    a.tiles.push_back(w);
  }
}

}  // namespace pantin
