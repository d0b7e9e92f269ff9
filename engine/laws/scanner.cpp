#include "laws/scanner.hpp"

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstdlib>

namespace pantin {

namespace {

struct Target {
  double x, y, z, reach2;
};

#ifdef __AVX2__
/// Shuffles of four 4-byte lanes that bring those of a mask to the front.
constexpr std::array<std::array<std::uint8_t, 16>, 16> make_compressions() {
  std::array<std::array<std::uint8_t, 16>, 16> table{};
  for (unsigned mask = 0; mask < 16; mask++) {
    unsigned to = 0;
    for (unsigned lane = 0; lane < 4; lane++) {
      if ((mask >> lane & 1) == 0) continue;
      for (unsigned byte = 0; byte < 4; byte++) table[mask][4 * to + byte] = static_cast<std::uint8_t>(4 * lane + byte);
      to++;
    }
  }
  return table;
}
alignas(16) constexpr std::array<std::array<std::uint8_t, 16>, 16> compressions = make_compressions();
#endif

/// Writes the sites of cells [k, end) that are within reach; gives the end of what it wrote. May write 4 sites further.
std::uint32_t* scan(const Cells& cells, std::size_t k, std::size_t end, const Target& t, std::uint32_t* out) {
  const double *x = cells.x.data(), *y = cells.y.data(), *z = cells.z.data();
  const std::uint32_t* site = cells.site.data();
#ifdef __AVX2__
  const __m256d tx = _mm256_set1_pd(t.x), ty = _mm256_set1_pd(t.y), tz = _mm256_set1_pd(t.z),
                reach2 = _mm256_set1_pd(t.reach2);
  for (; k < end; k += 4) {
    const __m256d dx = _mm256_sub_pd(_mm256_loadu_pd(x + k), tx), dy = _mm256_sub_pd(_mm256_loadu_pd(y + k), ty),
                  dz = _mm256_sub_pd(_mm256_loadu_pd(z + k), tz);
    const __m256d d2 =
        _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(dx, dx), _mm256_mul_pd(dy, dy)), _mm256_mul_pd(dz, dz));
    auto mask = static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(d2, reach2, _CMP_LT_OQ)));
    if (end - k < 4) mask &= (1u << (end - k)) - 1u;
    const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(site + k));
    const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(compressions[mask].data()));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_shuffle_epi8(four, order));
    out += __builtin_popcount(mask);
  }
#else
  for (; k < end; k++) {
    const double dx = x[k] - t.x, dy = y[k] - t.y, dz = z[k] - t.z;
    *out = site[k];
    out += dx * dx + dy * dy + dz * dz < t.reach2 ? 1 : 0;
  }
#endif
  return out;
}

/// How many boxes a cell number lies beyond the box; 0 in open space.
std::int32_t turns_of(const Grid& grid, Grid::Axis k, std::int32_t cell) {
  if (!grid.periodic) return 0;
  const std::int32_t n = grid.cells[k];
  return (cell >= 0 ? cell : cell - n + 1) / n;
}

}  // namespace

bool Omitted::has(std::uint32_t i) const {
  return sites.kin[i] != 0 || !sites.excluded.of(i).empty() || !further.of(i).empty();
}

std::uint32_t* Omitted::remove(std::uint32_t i, std::uint32_t* begin, std::uint32_t* end) const {
  if (sites.kin[i] != 0)
    end = std::remove_if(begin, end, [&](std::uint32_t j) { return sites.kin[j] == sites.kin[i]; });
  for (const std::span<const std::uint32_t> list : {sites.excluded.of(i), further.of(i)}) {
    if (list.empty()) continue;
    end = std::remove_if(begin, end,
                         [&](std::uint32_t j) { return std::find(list.begin(), list.end(), j) != list.end(); });
  }
  return end;
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
  std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) { return p.shift < q.shift; });
}

void Scanner::add_pieces(std::int32_t layer, std::int32_t row, std::size_t shift, bool self) {
  const std::ptrdiff_t found = b_.find_line(layer, row);
  if (found < 0) return;
  const std::uint32_t begin = b_.lines[static_cast<std::size_t>(found)].begin,
                      end = b_.lines[static_cast<std::size_t>(found) + 1].begin;
  for (std::int32_t turns = grid_.periodic ? -1 : 0; turns <= (grid_.periodic ? 1 : 0); turns++) {
    if (self && turns < 0) continue;
    const auto along = static_cast<std::int32_t>(stride(Grid::of_line)) * turns;
    pieces_.push_back({shift + static_cast<std::size_t>(along), begin, begin, end, turns, self && turns == 0});
  }
}

void Scanner::move_on(std::int32_t at) {
  const std::int32_t around = Grid::around, n = grid_.cells[Grid::of_line];
  ranges_.clear();
  for (Piece& piece : pieces_) {
    const std::int32_t from = (piece.self ? at : at - around) - piece.turns * n, to = at + around - piece.turns * n;
    while (piece.low < piece.end && b_.cells[piece.low].at < from) piece.low++;
    piece.high = std::max(piece.high, piece.low);
    while (piece.high < piece.end && b_.cells[piece.high].at <= to) piece.high++;
    const std::uint32_t begin = b_.cells[piece.low].begin, end = b_.cells[piece.high].begin;
    if (begin < end) ranges_.push_back({piece.shift, begin, end, piece.self});
  }
}

std::uint64_t Scanner::add_site(Slab& slab, std::size_t k) {
  const std::uint32_t site = a_.site[k];
  const bool excludes = omitted_.has(site);
  std::uint64_t pairs = 0;
  for (auto range = ranges_.begin(); range != ranges_.end();) {
    const std::size_t shift = range->shift, begin = slab.own.size();
    std::size_t candidates = 0;
    auto last = range;
    for (; last != ranges_.end() && last->shift == shift; last++) candidates += last->end - last->begin;
    slab.own.resize(begin + candidates + 4);
    const Target target{a_.x[k] - shifts_[shift][0], a_.y[k] - shifts_[shift][1], a_.z[k] - shifts_[shift][2], reach2_};
    std::uint32_t *first = slab.own.data() + begin, *out = first;
    for (; range != last; range++) out = scan(b_, range->self ? k + 1 : range->begin, range->end, target, out);
    if (excludes) out = omitted_.remove(site, first, out);
    const auto count = static_cast<std::size_t>(out - first);
    slab.own.resize(begin);
    if (count == 0) continue;
    slab.own.resize(begin + count);
    close_row(slab, site, begin, count, shift, omitted_.sites.dummy());
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
      if (slab.own.size() > Rows::most_pairs) return Rows::most_pairs + 1;
    }
  }
  return pairs;
}

}  // namespace pantin
