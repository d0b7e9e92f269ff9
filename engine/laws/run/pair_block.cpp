#include "laws/run/pair_block.hpp"

#include <algorithm>
#include <cstring>

#include "base/lengths.hpp"
#include "laws/run/compress.hpp"

namespace pantin {

namespace {

/// Writes those of four neighbours whose r2 is below the cutoff's square, and gives their number. May write four.
int keep_near(Vec3 r2, const std::uint32_t* j, double cutoff2, double* r2_to, std::uint32_t* to) {
#ifdef __AVX2__
  const __m256d lanes = r2;
  const auto mask =
      static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(lanes, _mm256_set1_pd(cutoff2), _CMP_LT_OQ)));
  _mm256_storeu_pd(r2_to, compressed(lanes, mask));
  const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(j));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), compressed(four, mask));
  return __builtin_popcount(mask);
#else
  int count = 0;
  for (int k = 0; k < 4; k++) {
    r2_to[count] = r2[k];
    to[count] = j[k];
    count += r2[k] < cutoff2 ? 1 : 0;
  }
  return count;
#endif
}

void store(double* to, Vec3 four) { std::memcpy(to, &four, sizeof four); }

/// May write three values more.
void fill(double* to, int n, double value) {
  for (int k = 0; k < n; k += 4) store(to + k, zero3() + value);
}

void pick(double* to, int n, const double* from, const std::uint32_t* which) {
  int k = 0;
  for (; k + 4 <= n; k += 4)
    store(to + k, Vec3{from[which[k]], from[which[k + 1]], from[which[k + 2]], from[which[k + 3]]});
  for (; k < n; k++) to[k] = from[which[k]];
}

}  // namespace

PairBlock::PairBlock(LawBlock made) : Block(std::move(made), LawBlock::most) {
  neighbours.assign(LawBlock::room, 0);
  in_lanes = true;
}

void PairBlock::take_near(const Sites& sites, const Vec3* shifts, const PairLimits& limits, Task& task) {
  constexpr std::ptrdiff_t most = LawBlock::most - 4;
  const Slab& slab = *task.slab;
  const Vec3* x = sites.x.data();
  const Vec3 least2 = zero3() + limits.least2;
  const double cutoff2 = limits.cutoff2;
  double* const r2_to = law.distance2;
  std::uint32_t* const to = neighbours.data();
  std::ptrdiff_t n = 0;
  Task next = task;
  part_count = 0;
  while (next.at < next.end && n <= most) {
    const NeighbourRow row = slab.rows[next.at];
    const Vec3 from = x[row.site] - shifts[row.shift];
    const std::uint32_t *j = slab.list + row.begin + next.offset, *const end = slab.list + row.begin + row.count;
    const std::ptrdiff_t begin = n;
    for (; j != end && n <= most; j += 4) {
      const Vec3 r2 = lengths2(from - x[j[0]], from - x[j[1]], from - x[j[2]], from - x[j[3]]);
      __builtin_prefetch(j + 256);
      n += keep_near(r2 > least2 ? r2 : least2, j, cutoff2, r2_to + n, to + n);
    }
    if (n > begin) parts[static_cast<std::size_t>(part_count++)] = {row.site, static_cast<int>(n - begin), from};
    if (j == end) {
      next.at++;
      next.offset = 0;
    } else {
      next.offset = row.count - static_cast<std::uint32_t>(end - j);
    }
  }
  task = next;
  count = static_cast<int>(n);
  std::fill_n(to + n, 4, n > 0 ? to[n - 1] : 0u);  // four at a time are looked at, and get nothing
}

void PairBlock::keep_touching(const double* radius) {
  double* r2 = law.distance2;
  int from = 0;
  count = 0;
  for (int p = 0; p < part_count; p++) {
    Part& part = parts[static_cast<std::size_t>(p)];
    const int begin = count, end = from + part.count;
    for (; from < end; from++) {
      const std::uint32_t j = neighbours[static_cast<std::size_t>(from)];
      const double reach = radius[part.site] + radius[j];
      r2[count] = r2[from];
      neighbours[static_cast<std::size_t>(count)] = j;
      count += r2[count] < reach * reach ? 1 : 0;
    }
    part.count = count - begin;
  }
}

void PairBlock::gather_vectors(const Sites& sites) {
  const Vec3 *x = sites.x.data(), *v = sites.v.data();
  each_part([&](const Part& part, int at) {
    for (auto k = static_cast<std::size_t>(at); k < static_cast<std::size_t>(at + part.count); k++) {
      d[k] = x[neighbours[k]] - part.from;
      if (law.wants_motion) u[k] = v[neighbours[k]] - v[part.site];
      if (law.approach) law.approach[k] = dot(d[k], u[k]);
    }
  });
  gather_components();
}

/// With the roles exchanged the row's site is b.
void PairBlock::gather_attributes(const Sites& sites, bool exchanged) {
  for (const LawBlock::Attribute& attribute : law.attributes) {
    const double* column = sites.attributes[attribute.column].data();
    const bool of_row = (attribute.who == 0) != exchanged;
    if (of_row)
      each_part([&](const Part& part, int at) { fill(attribute.to + at, part.count, column[part.site]); });
    else
      pick(attribute.to, count, column, neighbours.data());
  }
}

void PairBlock::gather_sites(bool exchanged) {
  std::uint32_t *of_row = law.sites[exchanged ? 1 : 0], *of_list = law.sites[exchanged ? 0 : 1];
  each_part([&](const Part& part, int at) { std::fill_n(of_row + at, part.count, part.site); });
  std::copy_n(neighbours.data(), count, of_list);
}

void PairBlock::gather(const Sites& sites, const Vec3* shifts, const PairLimits& limits, const double* radius,
                       Task& task) {
  sign = 1.0;
  take_near(sites, shifts, limits, task);
  if (radius != nullptr) keep_touching(radius);
  if (law.wants_displacement || law.wants_motion) gather_vectors(sites);
  if (code)
    law.bind_attributes(sites);
  else
    gather_attributes(sites, false);
  if (law.wants_sites) gather_sites(false);
}

void PairBlock::exchange_roles(const Sites& sites) {
  sign = -1.0;
  gather_components();
  gather_attributes(sites, true);
  if (law.wants_sites) gather_sites(true);
}

}  // namespace pantin
