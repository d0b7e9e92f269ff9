#include "laws/run/scanner.hpp"

#include <algorithm>
#include <utility>

#include "base/stable.hpp"
#include "laws/run/compress.hpp"

namespace pantin {

namespace {

struct Target {
  double x, y, z, reach2;
};

/// Where the columns of cells are.
struct CellColumns {
  const double *x, *y, *z;
  const std::uint32_t* site;

  explicit CellColumns(const Cells& cells)
      : x(cells.x.data()), y(cells.y.data()), z(cells.z.data()), site(cells.site.data()) {}
};

/// Writes those of four sites of cells, from the k-th on, that the mask names and that are within reach; gives the end
/// of what it wrote. May write four.
std::uint32_t* scan_four(const CellColumns& cells, std::size_t k, unsigned mask, const Target& t, std::uint32_t* out) {
  const double *x = cells.x + k, *y = cells.y + k, *z = cells.z + k;
  const std::uint32_t* site = cells.site + k;
#ifdef __AVX2__
  const __m256d dx = _mm256_loadu_pd(x) - t.x, dy = _mm256_loadu_pd(y) - t.y, dz = _mm256_loadu_pd(z) - t.z;
  const __m256d near = _mm256_cmp_pd(dx * dx + dy * dy + dz * dz, _mm256_set1_pd(t.reach2), _CMP_LT_OQ);
  mask &= static_cast<unsigned>(_mm256_movemask_pd(near));
  const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(site));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), compressed(four, mask));
  return out + __builtin_popcount(mask);
#else
  for (int i = 0; i < 4; i++) {
    const double dx = x[i] - t.x, dy = y[i] - t.y, dz = z[i] - t.z;
    *out = site[i];
    out += (mask >> i & 1u) != 0 && dx * dx + dy * dy + dz * dz < t.reach2 ? 1 : 0;
  }
  return out;
#endif
}

/// Lanes of those of four from k on that are before the end.
std::uint32_t lanes_before(std::uint32_t end, std::uint32_t k) { return (1u << std::min(end - k, 4u)) - 1u; }

/// How many boxes a cell number lies beyond the box; 0 in open space.
std::int32_t turns_of(const Grid& grid, Grid::Axis k, std::int32_t cell) {
  if (!grid.periodic) return 0;
  const std::int32_t n = grid.cells[k];
  return (cell >= 0 ? cell : cell - n + 1) / n;
}

}  // namespace

bool Omitted::has(std::uint32_t i) const { return sites.kin[i].first != 0 || !further.of(i).empty(); }

std::uint32_t* Omitted::remove(std::uint32_t i, std::uint32_t* begin, std::uint32_t* end) const {
  if (sites.kin[i].first != 0) end = std::remove_if(begin, end, [&](std::uint32_t j) { return sites.are_kin(i, j); });
  const std::span<const std::uint32_t> list = further.of(i);
  if (list.empty()) return end;
  return std::remove_if(begin, end,
                        [&](std::uint32_t j) { return std::find(list.begin(), list.end(), j) != list.end(); });
}

void close_row(Slab& slab, std::uint32_t site, std::size_t begin, std::size_t count, std::size_t shift,
               std::uint32_t dummy) {
  const std::size_t padded = (count + 3) / 4 * 4;
  slab.own.resize(begin + padded);
  std::fill(slab.own.begin() + begin + count, slab.own.end(), dummy);
  slab.rows.push_back(
      {site, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(padded), static_cast<std::uint32_t>(shift)});
}

void Scanner::find_pieces(const Cells::Line& line) {
  pieces_.clear();
  for (std::int32_t i = within_ ? 0 : -Grid::around; i <= Grid::around; i++) {
    for (std::int32_t j = within_ && i == 0 ? 0 : -Grid::around; j <= Grid::around; j++) {
      const std::int32_t layer_turns = turns_of(grid_, Grid::of_layer, line.layer + i);
      const std::int32_t row_turns = turns_of(grid_, Grid::of_row, line.row + j);
      if (std::abs(layer_turns) > 1 || std::abs(row_turns) > 1) continue;
      const auto shift = static_cast<std::size_t>(13 + layer_turns * static_cast<std::int32_t>(stride(Grid::of_layer)) +
                                                  row_turns * static_cast<std::int32_t>(stride(Grid::of_row)));
      add_pieces(line.layer + i - layer_turns * grid_.cells[Grid::of_layer],
                 line.row + j - row_turns * grid_.cells[Grid::of_row], shift, within_ && i == 0 && j == 0);
    }
  }
  sort_stably(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) { return p.shift < q.shift; });
}

void Scanner::add_pieces(std::int32_t layer, std::int32_t row, std::size_t shift, bool self) {
  const std::ptrdiff_t found = b_.find_line(layer, row);
  if (found < 0) return;
  const std::uint32_t begin = b_.lines[static_cast<std::size_t>(found)].begin,
                      end = b_.lines[static_cast<std::size_t>(found) + 1].begin;
  for (std::int32_t turns = grid_.periodic ? -1 : 0; turns <= (grid_.periodic ? 1 : 0); turns++) {
    if (self && turns < 0) continue;
    const auto along = static_cast<std::int32_t>(stride(Grid::of_line)) * turns;
    pieces_.push_back({shift + static_cast<std::size_t>(along), static_cast<std::size_t>(found), begin, begin, end,
                       turns, self && turns == 0});
  }
}

std::pair<std::uint32_t, std::uint32_t> Scanner::find_range(Piece& piece, std::int32_t from, std::int32_t to) const {
  if (b_.is_dense()) {
    const std::int32_t last = grid_.cells[Grid::of_line] - 1;
    return {b_.begin_of(piece.line, std::max(from, 0)), b_.begin_of(piece.line, std::min(to, last) + 1)};
  }
  while (piece.low < piece.end && b_.cells[piece.low].at < from) piece.low++;
  piece.high = std::max(piece.high, piece.low);
  while (piece.high < piece.end && b_.cells[piece.high].at <= to) piece.high++;
  return {b_.cells[piece.low].begin, b_.cells[piece.high].begin};
}

void Scanner::move_on(std::int32_t at) {
  const std::int32_t around = Grid::around, n = grid_.cells[Grid::of_line];
  views_.clear();
  fours_.resize(0);
  for (Piece& piece : pieces_) {
    const std::int32_t from = (piece.self ? at : at - around) - piece.turns * n, to = at + around - piece.turns * n;
    if (from >= n || to < 0) continue;
    const auto [begin, end] = find_range(piece, from, to);
    if (begin == end) continue;
    if (views_.empty() || views_.back().shift != piece.shift) views_.push_back({piece.shift, fours_.size(), 0, 0});
    if (piece.self)
      views_.back().self_end = end;
    else
      add_fours(begin, end);
    views_.back().end = fours_.size();
  }
}

void Scanner::add_fours(std::uint32_t begin, std::uint32_t end) {
  constexpr std::size_t often = 4;  // which are written whether needed or not: the processor cannot guess the number
  const std::size_t first = fours_.size(), count = (end - begin + 3) / 4;
  fours_.resize(first + std::max(count, often));
  Four* four = fours_.data() + first;
  const auto make = [&](std::size_t k) {
    const auto at = static_cast<std::uint32_t>(begin + 4 * k);
    four[k] = {at, lanes_before(end, at)};
  };
  for (std::size_t k = 0; k < often; k++) make(k);
  for (std::size_t k = often; k < count; k++) make(k);
  fours_.resize(first + count);
}

std::uint64_t Scanner::add_site(Slab& slab, std::uint32_t k) {
  const std::uint32_t site = a_.site[k];
  const bool excludes = omitted_.has(site);
  const CellColumns columns(b_);
  std::uint64_t pairs = 0;
  for (const View& view : views_) {
    const std::size_t begin = slab.own.size(), after = view.self_end > k ? view.self_end - k : 0;
    slab.own.resize(begin + 4 * (view.end - view.begin) + after + 4);
    const Vec3 shift = shifts_[view.shift];
    const Target target{a_.x[k] - shift[0], a_.y[k] - shift[1], a_.z[k] - shift[2], reach2_};
    std::uint32_t *first = slab.own.data() + begin, *out = first;
    for (std::uint32_t j = k + 1; j < view.self_end; j += 4)
      out = scan_four(columns, j, lanes_before(view.self_end, j), target, out);
    for (const Four *four = fours_.data() + view.begin, *end = fours_.data() + view.end; four != end; four++)
      out = scan_four(columns, four->begin, four->lanes, target, out);
    if (excludes) out = omitted_.remove(site, first, out);
    const auto count = static_cast<std::size_t>(out - first);
    slab.own.resize(begin + count);
    if (count > 0) close_row(slab, site, begin, count, view.shift, omitted_.sites.dummy());
    pairs += count;
  }
  return pairs;
}

std::uint64_t Scanner::add_line(Slab& slab, std::size_t number) {
  const Cells::Line& line = a_.lines[number];
  find_pieces(line);
  std::uint64_t pairs = 0;
  for (std::uint32_t c = line.begin; c < a_.lines[number + 1].begin; c++) {
    move_on(a_.cells[c].at);
    for (std::uint32_t k = a_.cells[c].begin; k < a_.cells[c + 1].begin; k++) {
      pairs += add_site(slab, k);
      if (slab.own.size() > NeighbourList::most_pairs) return NeighbourList::most_pairs + 1;
    }
  }
  return pairs;
}

}  // namespace pantin
