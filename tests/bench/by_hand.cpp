#include "bench/by_hand.hpp"

#ifdef __AVX__
#include <immintrin.h>
#endif

#include <algorithm>
#include <vector>

#include "base/lengths.hpp"
#include "base/parallel.hpp"
#include "bench/clock.hpp"
#include "laws/run/cells.hpp"
#include "laws/run/neighbours.hpp"
#include "laws/run/skin.hpp"

namespace pantin::by_hand {

namespace {

constexpr double cutoff = 2.5, width = 0.3, dt = 0.005;
const std::vector<std::uint32_t> everybody = {0};

Vec3 all(double x) { return zero3() + x; }

Vec3 square_roots(Vec3 x) {
#ifdef __AVX__
  return _mm256_sqrt_pd(x);
#else
  for (int k = 0; k < 4; k++) x[k] = std::sqrt(x[k]);
  return x;
#endif
}

void permute(auto& values, const std::vector<std::uint32_t>& order) {
  const auto old = values;
  for (std::size_t i = 0; i < order.size(); i++) values[i] = old[order[i]];
}

/// Each law gives force over distance of the pairs of site i with j[0] … j[3].
struct LennardJones {
  explicit LennardJones(const Sites&) {}
  Vec3 operator()(Vec3 r2, std::uint32_t, const std::uint32_t*) const {
    const Vec3 i2 = all(1.0) / r2, i6 = i2 * i2 * i2;
    return i6 * (48.0 * i6 - 24.0) * i2;
  }
};

struct FourAttributes {
  const double *size, *depth;
  explicit FourAttributes(const Sites& s) : size(s.attributes[0].data()), depth(s.attributes[1].data()) {}
  static Vec3 of(const double* column, const std::uint32_t* j) {
    return Vec3{column[j[0]], column[j[1]], column[j[2]], column[j[3]]};
  }
  Vec3 operator()(Vec3 r2, std::uint32_t i, const std::uint32_t* j) const {
    const Vec3 s = size[i] + of(size, j), i2 = all(1.0) / r2, s2 = s * s * i2, s6 = s2 * s2 * s2;
    return depth[i] * of(depth, j) * s6 * (48.0 * s6 - 24.0) * i2;
  }
};

struct SmoothSwitch {
  explicit SmoothSwitch(const Sites&) {}
  Vec3 operator()(Vec3 r2, std::uint32_t, const std::uint32_t*) const {
    const Vec3 i2 = all(1.0) / r2, i6 = i2 * i2 * i2, r = square_roots(r2);
    Vec3 s = (r - 2.0) * 2.0;
    s = s > zero3() ? s : zero3();
    const Vec3 s2 = s * s, on = 1.0 - s2 * s * (10.0 - s * (15.0 - 6.0 * s));
    const Vec3 back = 1.0 - s, slope = -60.0 * s2 * back * back;
    return i6 * ((48.0 * i6 - 24.0) * i2 * on - 4.0 * (i6 - 1.0) * slope * r * i2);
  }
};

template <class Law>
void add_forces(Sites& sites, const NeighbourList& rows) {
  const Law law(sites);
  const Vec3* x = sites.x.data();
  Vec3* f = sites.force.data();
  const Vec3 cutoff2 = all(cutoff * cutoff);
  for (const auto& phase : rows.phases())
    for (const Slab& slab : phase)
      for (const NeighbourRow& row : slab.rows) {
        const Vec3 from = x[row.site] - rows.shifts()[row.shift];
        const std::uint32_t* j = slab.list + row.begin;
        Vec3 sum = zero3(), other = zero3();
        for (std::uint32_t k = 0; k < row.count; k += 4) {
          Vec3 a = from - x[j[k]], b = from - x[j[k + 1]], c = from - x[j[k + 2]], d = from - x[j[k + 3]];
          const Vec3 r2 = lengths2(a, b, c, d);
          Vec3 w = law(r2, row.site, j + k);
          w = r2 < cutoff2 ? w : zero3();
          a *= w[0];
          b *= w[1];
          c *= w[2];
          d *= w[3];
          sum += a;
          other += b;
          sum += c;
          other += d;
          f[j[k]] -= a;
          f[j[k + 1]] -= b;
          f[j[k + 2]] -= c;
          f[j[k + 3]] -= d;
        }
        f[row.site] += sum + other;
      }
}

void sort(Sites& s, const Box& box) {
  for (std::size_t i = 0; i < s.n; i++) s.x[i] = box.wrapped(s.x[i]);
  const std::vector<std::uint32_t> order = cell_order({s.x.data(), s.n}, box, 0.5 * (cutoff + width));
  permute(s.x, order);
  permute(s.v, order);
  permute(s.force, order);
  for (auto& column : s.attributes) permute(column, order);
}

template <class Law>
double run(const cases::Melt& melt, int steps) {
  Workers alone(1);
  Sites s;
  s.names = {"size", "depth"};
  s.resize(melt.positions.size());
  s.clear_forces();
  std::fill(s.family.begin(), s.family.end(), 0u);
  std::fill(s.kin.begin(), s.kin.end(), Kin{});
  s.attributes[0].assign(s.attributes[0].size(), 0.5);
  s.attributes[1].assign(s.attributes[1].size(), 1.0);
  std::copy(melt.positions.begin(), melt.positions.end(), s.x.begin());
  std::copy(melt.velocities.begin(), melt.velocities.end(), s.v.begin());
  const Box box{vec(melt.edge, melt.edge, melt.edge)};
  NeighbourList rows;
  Skin skin;
  const auto evaluate = [&] {
    if (skin.spent(s)) {
      sort(s, box);
      rows.build(s, box, everybody, everybody, cutoff, width, alone);
      skin.restart(s, width);
    }
    std::fill(s.force.begin(), s.force.end(), zero3());
    add_forces<Law>(s, rows);
  };
  evaluate();
  const double start = now();
  for (int step = 0; step < steps; step++) {
    for (std::size_t i = 0; i < s.n; i++) {
      s.v[i] += s.force[i] * (0.5 * dt);
      s.x[i] += s.v[i] * dt;
    }
    evaluate();
    for (std::size_t i = 0; i < s.n; i++) s.v[i] += s.force[i] * (0.5 * dt);
  }
  return now() - start;
}

}  // namespace

double run_melt(const cases::Melt& melt, int steps, Law law) {
  if (law == Law::four_attributes) return run<FourAttributes>(melt, steps);
  return law == Law::smooth_switch ? run<SmoothSwitch>(melt, steps) : run<LennardJones>(melt, steps);
}

void add_springs(Sites& sites, const BondList& ties) {
  const double *stiffness = ties.parameters[0].data(), *length = ties.parameters[1].data();
  Vec3 sum = zero3();
  std::uint32_t present = ties.sites[0];
  for (std::size_t i = 0; i < ties.size(); i++) {
    const std::uint32_t a = ties.sites[2 * i], b = ties.sites[2 * i + 1];
    if (a != present) {
      sites.force[present] += sum;
      sum = zero3();
      present = a;
    }
    const Vec3 d = sites.x[b] - sites.x[a];
    const double r = norm(d);
    const Vec3 f = d * (stiffness[i] * (r - length[i]) / r);
    sum += f;
    sites.force[b] -= f;
  }
  sites.force[present] += sum;
}

}  // namespace pantin::by_hand
