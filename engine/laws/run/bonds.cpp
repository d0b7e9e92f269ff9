#include "laws/run/bonds.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "base/lengths.hpp"

namespace pantin {

namespace {

constexpr std::size_t block_size = 48;  // what a block touches stays in the first cache

/// Positions [begin, begin + n) of the arranged connections.
struct Stretch {
  std::size_t begin;
  std::size_t n;
};

void store4(double* to, Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 least) {
  const Vec3 squares = lengths2(a, b, c, d);
  *reinterpret_cast<Vec3*>(to) = squares > least ? squares : least;
}

template <bool periodic>
void gather_distances(Block& block, const Arranged& bonds, Stretch at, const Sites& sites, const Box& box,
                      double least2, const AlignedVector<Vec3>& forces) {
  const std::uint32_t *a = bonds.sites[0].data() + at.begin, *b = bonds.sites[1].data() + at.begin;
  const Vec3* x = sites.x.data();
  Vec3* d = block.d.data();
  double* r2 = block.law.distance2;
  const Vec3 least = zero3() + least2;
  const auto vector = [&](std::size_t k) { return periodic ? box.nearest(x[b[k]] - x[a[k]]) : x[b[k]] - x[a[k]]; };
  const Vec3* force = forces.data();
  std::size_t k = 0;
  for (; k + 4 <= at.n; k += 4) {
    for (std::size_t l = k; l < k + 4; l++) __builtin_prefetch(force + b[l], 1);  // for the scatter
    const Vec3 p = vector(k), q = vector(k + 1), r = vector(k + 2), s = vector(k + 3);
    d[k] = p;
    d[k + 1] = q;
    d[k + 2] = r;
    d[k + 3] = s;
    store4(r2 + k, p, q, r, s, least);
  }
  for (; k < at.n; k++) {
    d[k] = vector(k);
    const Vec3 c = d[k] * d[k];
    const double sum = (c[0] + c[1]) + c[2];
    r2[k] = sum > least2 ? sum : least2;
  }
}

void gather_motion(Block& block, const Arranged& bonds, Stretch at, const Sites& sites) {
  for (std::size_t k = 0; k < at.n; k++)
    block.u[k] = sites.v[bonds.sites[1][at.begin + k]] - sites.v[bonds.sites[0][at.begin + k]];
  if (double* approach = block.law.approach)
    for (std::size_t k = 0; k < at.n; k++) approach[k] = dot(block.d[k], block.u[k]);
}

/// Places of the others are those nearest to the first.
void gather_positions(LawBlock& law, const Arranged& bonds, Stretch at, const Sites& sites, const Box& box,
                      std::size_t count) {
  for (std::size_t who = 0; who < count; who++)
    for (std::size_t k = 0; k < at.n; k++) {
      const Vec3 first = sites.x[bonds.sites[0][at.begin + k]];
      const Vec3 x = first + box.nearest(sites.x[bonds.sites[who][at.begin + k]] - first);
      for (std::size_t c = 0; c < 3; c++)
        if (law.position[who][c] != nullptr) law.position[who][c][k] = x[static_cast<int>(c)];
    }
}

/// Connections of one first site follow each other: their forces on it are summed up before it is touched.
void scatter_central(const Block& block, const Arranged& bonds, Stretch at, bool one_sided, Vec3* force) {
  const std::uint32_t *a = bonds.sites[0].data() + at.begin, *b = bonds.sites[1].data() + at.begin;
  const double* w = block.law.output(0);
  Vec3 sum = zero3();
  std::uint32_t present = a[0];
  for (std::size_t k = 0; k < at.n; k++) {
    const Vec3 f = block.d[k] * w[k];
    if (a[k] != present) {
      force[present] += sum;
      sum = zero3();
      present = a[k];
    }
    sum += f;
    if (!one_sided) force[b[k]] -= f;
  }
  force[present] += sum;
}

void scatter_forces(const LawBlock& law, const Arranged& bonds, Stretch at, std::size_t count, Vec3* force) {
  for (std::size_t who = 0; who < count; who++) {
    const double *x = law.output(3 * who), *y = law.output(3 * who + 1), *z = law.output(3 * who + 2);
    for (std::size_t k = 0; k < at.n; k++) force[bonds.sites[who][at.begin + k]] += vec(x[k], y[k], z[k]);
  }
}

void scatter_pair(const LawBlock& law, const Arranged& bonds, Stretch at, bool one_sided, Vec3* force) {
  const double *x = law.output(0), *y = law.output(1), *z = law.output(2);
  for (std::size_t k = 0; k < at.n; k++) {
    const Vec3 f = vec(x[k], y[k], z[k]);
    force[bonds.sites[0][at.begin + k]] += f;
    if (!one_sided) force[bonds.sites[1][at.begin + k]] -= f;
  }
}

}  // namespace

Bonds::Bonds(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : LawOnSites(std::move(law), names, workers) {
  assume(this->law().kind != LawKind::point);
  make_blocks();
}

void Bonds::arrange(const BondList& ties, const Sites& sites) {
  assume(ties.count == law().count);
  assume(ties.parameters.empty() || ties.parameters.size() == law().parameters.size());
  bonds_.arrange(ties, sites.n);
  if (own_parameters_ == ties.parameters.empty()) {
    own_parameters_ = !own_parameters_;
    drop_blocks(own_parameters_);
  }
  pull_.assign(bonds_.n, 0.0);
  asked_.is_new = false;
  double longest2 = 0.0;
  for (std::size_t i = 0; i < bonds_.n; i++)
    longest2 = std::max(longest2, norm2(sites.x[bonds_.sites[1][i]] - sites.x[bonds_.sites[0][i]]));
  least2_ = 1e-24 * (longest2 > 0.0 && longest2 < infinity ? longest2 : 1.0);
}

Task Bonds::task(std::size_t phase, std::size_t number) const {
  const Arranged::Range& range = bonds_.phases[phase][number];
  return {.at = range.begin, .end = range.end};
}

std::unique_ptr<Block> Bonds::make_block(LawBlock made) const {
  return std::make_unique<Block>(std::move(made), law().kind == LawKind::many ? 0 : block_size);
}

void Bonds::gather(Block& block, Task& task, const Sites& sites, const Box& box) const {
  const Stretch at{task.at, std::min(block_size, task.end - task.at)};
  const auto count = static_cast<std::size_t>(law().count);
  task.at += at.n;
  block.first = at.begin;
  block.count = static_cast<int>(at.n);
  for (std::size_t p = 0; p < bonds_.parameters.size(); p++)
    block.law.bind_parameter(p, bonds_.parameters[p].data() + at.begin);
  if (block.law.wants_sites || !block.law.attributes.empty()) {
    std::array<const std::uint32_t*, 4> roles{};
    for (std::size_t who = 0; who < count; who++) roles[who] = bonds_.sites[who].data() + at.begin;
    block.law.gather_of({roles.data(), count}, at.n, sites);
  }
  if (law().kind == LawKind::many) return gather_positions(block.law, bonds_, at, sites, box, count);
  if (box.periodic())
    gather_distances<true>(block, bonds_, at, sites, box, least2_, force_of(sites));
  else
    gather_distances<false>(block, bonds_, at, sites, box, least2_, force_of(sites));
  if (block.law.wants_motion) gather_motion(block, bonds_, at, sites);
  if (block.law.wants_displacement || block.law.wants_motion) block.gather_components();
}

void Bonds::scatter(const Block& block, const Sites& /*sites*/, Vec3* force) {
  const Stretch at{block.first, static_cast<std::size_t>(block.count)};
  if (law().called) keep_pulls(block);
  switch (law().kind) {
    case LawKind::central: return scatter_central(block, bonds_, at, law().one_sided, force);
    case LawKind::pair: return scatter_pair(block.law, bonds_, at, law().one_sided, force);
    case LawKind::many: return scatter_forces(block.law, bonds_, at, static_cast<std::size_t>(law().count), force);
    case LawKind::point: assume(false);
  }
}

void Bonds::keep_pulls(const Block& block) {
  if (law().kind == LawKind::central) std::copy_n(block.law.output(0), block.count, pull_.data() + block.first);
}

double Bonds::pull(std::size_t connection, const Sites& sites, const Box& box) {
  if (std::exchange(asked_.is_new, false) && !law().called) {
    Block& block = *blocks(asked_.with_energy).front();
    block.law.set(asked_.instant, asked_.parameters);
    for (const Task& task : in_order())
      each_block(block, task, sites, box, [&](const Block& made) { keep_pulls(made); });
  }
  return pull_[bonds_.position[connection]];
}

double Bonds::tension(std::size_t connection, const Sites& sites, const Box& box) {
  const std::size_t k = bonds_.position[connection];
  return pull(connection, sites, box) * norm(box.nearest(sites.x[bonds_.sites[1][k]] - sites.x[bonds_.sites[0][k]]));
}

}  // namespace pantin
