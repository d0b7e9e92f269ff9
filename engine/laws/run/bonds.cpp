#include "laws/run/bonds.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "base/compensated.hpp"
#include "base/lengths.hpp"
#include "laws/run/arranged.hpp"
#include "laws/run/block.hpp"
#include "laws/run/pair_slopes.hpp"
#include "laws/velocity_slopes.hpp"

namespace pantin {

namespace {

constexpr std::size_t block_size = 48;  // what a block touches stays in the first cache

/// A block with the vectors between the ends of its connections.
struct BondBlock {
  LawBlock law;
  AlignedVector<Vec3> d;  ///< [m] from the first to the second
  AlignedVector<Vec3> u;  ///< [m/s]

  explicit BondBlock(LawBlock made) : law(std::move(made)) {
    d.assign(block_size, zero3());
    u.assign(block_size, zero3());
  }
};

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
void gather_distances(BondBlock& block, const Arranged& bonds, Stretch at, const Sites& sites, const Box& box,
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

void gather_components(const AlignedVector<Vec3>& from, std::size_t n, const LawBlock::Vector& to) {
  for (std::size_t c = 0; c < 3; c++)
    if (double* column = to[c])
      for (std::size_t k = 0; k < n; k++) column[k] = from[k][static_cast<int>(c)];
}

void gather_motion(BondBlock& block, const Arranged& bonds, Stretch at, const Sites& sites) {
  for (std::size_t k = 0; k < at.n; k++)
    block.u[k] = sites.v[bonds.sites[1][at.begin + k]] - sites.v[bonds.sites[0][at.begin + k]];
  if (double* approach = block.law.approach)
    for (std::size_t k = 0; k < at.n; k++) approach[k] = dot(block.d[k], block.u[k]);
  gather_components(block.u, at.n, block.law.relative_velocity);
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

void gather_others(LawBlock& law, const Arranged& bonds, Stretch at, const Sites& sites, std::size_t count) {
  for (const LawBlock::Attribute& attribute : law.attributes) {
    const double* column = sites.attributes[attribute.column].data();
    const std::uint32_t* site = bonds.sites[attribute.who].data() + at.begin;
    for (std::size_t k = 0; k < at.n; k++) attribute.to[k] = column[site[k]];
  }
  for (std::size_t who = 0; law.wants_sites && who < count; who++)
    std::copy_n(bonds.sites[who].begin() + static_cast<std::ptrdiff_t>(at.begin), at.n, law.sites[who]);
}

/// Connections of one first site follow each other: their forces on it are summed up before it is touched.
void scatter_central(const BondBlock& block, const Arranged& bonds, Stretch at, bool one_sided, Vec3* force) {
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

struct Bonds::Kernel {
  std::shared_ptr<const Law> law;
  std::vector<std::string> names;
  std::size_t workers = 1;
  std::vector<BondBlock> plain, energetic;  // one for each worker
  std::vector<BondBlock> sloped;            // one of a law of velocity, once its derivatives are asked for
  bool linear = false;                      // in velocity
  bool own_parameters = false;              // what the blocks are made for
  Arranged bonds;
  AlignedVector<double> pull;  // tension / distance at the last evaluation, by position
  BondBlock* last = nullptr;   // that of the evaluation, while the pulls are still to be found
  double least2 = 0.0;         // [m²]
  std::vector<CompensatedSum> energies;

  std::size_t count() const { return static_cast<std::size_t>(law->count); }
  void make_blocks();
  void gather(BondBlock& block, Stretch at, const Sites& sites, const Box& box) const;
  void scatter(const BondBlock& block, Stretch at, Sites& sites) const;
  void keep_pulls(const BondBlock& block, Stretch at) {
    if (law->kind == LawKind::central) std::copy_n(block.law.output(0), at.n, pull.begin() + at.begin);
  }
  void find_pulls(const Sites& sites, const Box& box);
  void add_range(BondBlock& block, Arranged::Range range, Sites& sites, const Box& box, CompensatedSum* energy);
  double add(std::vector<BondBlock>& blocks, Sites& sites, const Box& box, const Instant& instant,
             std::span<const double> parameters, Workers& shared, bool with_energy);
};

void Bonds::Kernel::make_blocks() {
  const Uniform uniform{!own_parameters};
  plain.clear();
  energetic.clear();
  sloped.clear();
  for (std::size_t k = 0; k < workers; k++) {
    plain.emplace_back(LawBlock(*law, false, names, uniform));
    if (law->has_energy()) energetic.emplace_back(LawBlock(*law, true, names, uniform));
  }
}

void Bonds::Kernel::gather(BondBlock& block, Stretch at, const Sites& sites, const Box& box) const {
  for (std::size_t p = 0; p < bonds.parameters.size(); p++)
    block.law.bind_parameter(p, bonds.parameters[p].data() + at.begin);
  gather_others(block.law, bonds, at, sites, count());
  if (law->kind == LawKind::many) {
    gather_positions(block.law, bonds, at, sites, box, count());
    return;
  }
  const AlignedVector<Vec3>& forces = law->has_energy() ? sites.force : sites.nonconservative_force;
  if (box.periodic())
    gather_distances<true>(block, bonds, at, sites, box, least2, forces);
  else
    gather_distances<false>(block, bonds, at, sites, box, least2, forces);
  if (block.law.wants_displacement) gather_components(block.d, at.n, block.law.displacement);
  if (block.law.wants_motion) gather_motion(block, bonds, at, sites);
}

void Bonds::Kernel::scatter(const BondBlock& block, Stretch at, Sites& sites) const {
  Vec3* force = law->has_energy() ? sites.force.data() : sites.nonconservative_force.data();
  switch (law->kind) {
    case LawKind::central: return scatter_central(block, bonds, at, law->one_sided, force);
    case LawKind::pair: return scatter_pair(block.law, bonds, at, law->one_sided, force);
    case LawKind::many: return scatter_forces(block.law, bonds, at, count(), force);
    case LawKind::point: assume(false);
  }
}

void Bonds::Kernel::add_range(BondBlock& block, Arranged::Range range, Sites& sites, const Box& box,
                              CompensatedSum* energy) {
  CompensatedSum sum;
  for (std::size_t begin = range.begin; begin < range.end; begin += block_size) {
    const Stretch at{begin, std::min(block_size, range.end - begin)};
    gather(block, at, sites, box);
    block.law.run(static_cast<int>(at.n), sites);
    scatter(block, at, sites);
    if (law->called) keep_pulls(block, at);
    if (energy == nullptr) continue;
    const double* each =
        block.law.output(law->kind == LawKind::central ? 1 : 3 * (law->kind == LawKind::pair ? 1 : count()));
    for (std::size_t k = 0; k < at.n; k++) sum.add(each[k]);
  }
  if (energy != nullptr) *energy = sum;
}

void Bonds::Kernel::find_pulls(const Sites& sites, const Box& box) {
  for (std::size_t begin = 0; begin < bonds.n; begin += block_size) {
    const Stretch at{begin, std::min(block_size, bonds.n - begin)};
    gather(*last, at, sites, box);
    last->law.run(static_cast<int>(at.n), sites);
    keep_pulls(*last, at);
  }
  last = nullptr;
}

double Bonds::Kernel::add(std::vector<BondBlock>& blocks, Sites& sites, const Box& box, const Instant& instant,
                          std::span<const double> parameters, Workers& shared, bool with_energy) {
  if (bonds.n == 0) return 0.0;
  const bool serial = law->called || bonds.phases.size() == 1;
  for (std::size_t k = 0; k < (serial ? 1 : blocks.size()); k++) blocks[k].law.set(instant, parameters);
  last = law->called ? nullptr : &blocks.front();
  CompensatedSum total;
  for (const std::vector<Arranged::Range>& phase : bonds.phases) {
    energies.resize(std::max(energies.size(), phase.size()));
    const auto task = [&](std::size_t k, int worker) {
      add_range(blocks[static_cast<std::size_t>(worker)], phase[k], sites, box, with_energy ? &energies[k] : nullptr);
    };
    if (serial)
      for (std::size_t k = 0; k < phase.size(); k++) task(k, 0);
    else
      shared.run(phase.size(), task);
    for (std::size_t k = 0; with_energy && k < phase.size(); k++) total.add(energies[k]);
  }
  return total.value();
}

Bonds::Bonds(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : kernel_(std::make_unique<Kernel>()) {
  assume(law->kind != LawKind::point);
  kernel_->law = std::move(law);
  kernel_->names.assign(names.begin(), names.end());
  kernel_->workers = static_cast<std::size_t>(workers.count());
  kernel_->make_blocks();
}

Bonds::~Bonds() = default;
Bonds::Bonds(const Bonds& other) : kernel_(std::make_unique<Kernel>()) {
  Kernel& k = *kernel_;
  const Kernel& from = *other.kernel_;
  k.law = from.law;
  k.names = from.names;
  k.workers = from.workers;
  k.own_parameters = from.own_parameters;
  k.bonds = from.bonds;
  k.pull = from.pull;
  k.least2 = from.least2;
  k.make_blocks();
  if (from.last == nullptr) return;
  k.last = from.last == &from.plain.front() ? &k.plain.front() : &k.energetic.front();
  k.last->law.set(from.last->law.instant(), from.last->law.parameters());
}
Bonds::Bonds(Bonds&&) noexcept = default;
Bonds& Bonds::operator=(Bonds&&) noexcept = default;

std::size_t Bonds::size() const { return kernel_->bonds.n; }
std::size_t Bonds::number(std::size_t k) const { return kernel_->bonds.connection[k]; }

void Bonds::arrange(const BondList& ties, const Sites& sites) {
  Kernel& k = *kernel_;
  assume(ties.count == k.law->count);
  assume(ties.parameters.empty() || ties.parameters.size() == k.law->parameters.size());
  k.bonds.arrange(ties, sites.n);
  if (k.own_parameters != !ties.parameters.empty()) {
    k.own_parameters = !ties.parameters.empty();
    k.make_blocks();
  }
  k.pull.assign(k.bonds.n, 0.0);
  k.last = nullptr;
  double longest2 = 0.0;
  for (std::size_t i = 0; i < k.bonds.n; i++)
    longest2 = std::max(longest2, norm2(sites.x[k.bonds.sites[1][i]] - sites.x[k.bonds.sites[0][i]]));
  k.least2 = 1e-24 * (longest2 > 0.0 && longest2 < infinity ? longest2 : 1.0);
}

void Bonds::add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                       Workers& workers) {
  kernel_->add(kernel_->plain, sites, box, instant, parameters, workers, false);
}

double Bonds::add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant,
                                    std::span<const double> parameters, Workers& workers) {
  const bool has = kernel_->law->has_energy();
  return kernel_->add(has ? kernel_->energetic : kernel_->plain, sites, box, instant, parameters, workers, has);
}

bool Bonds::list_slopes(const Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                        std::vector<VelocityPair>& to) const {
  Kernel& kernel = *kernel_;
  assume(kernel.law->kind != LawKind::many);
  if (kernel.sloped.empty()) {
    const std::shared_ptr<const Law> law = with_velocity_slopes(*kernel.law);
    kernel.linear = is_linear_in_velocity(*law);
    kernel.sloped.emplace_back(LawBlock(*law, false, kernel.names, Uniform{!kernel.own_parameters}));
  }
  BondBlock& block = kernel.sloped.front();
  block.law.set(instant, parameters);
  PairSlopes slopes(*kernel.law, sites, to);
  for (std::size_t begin = 0; begin < kernel.bonds.n; begin += block_size) {
    const Stretch at{begin, std::min(block_size, kernel.bonds.n - begin)};
    kernel.gather(block, at, sites, box);
    block.law.run(static_cast<int>(at.n), sites);
    slopes.take(block.law, at.n, block.d.data(), block.u.data(), [&](std::size_t k) {
      return std::pair(kernel.bonds.sites[0][begin + k], kernel.bonds.sites[1][begin + k]);
    });
  }
  return kernel.linear;
}

double Bonds::pull(std::size_t connection, const Sites& sites, const Box& box) const {
  if (kernel_->last != nullptr) kernel_->find_pulls(sites, box);
  return kernel_->pull[kernel_->bonds.position[connection]];
}

double Bonds::tension(std::size_t connection, const Sites& sites, const Box& box) const {
  const Arranged& bonds = kernel_->bonds;
  const std::size_t k = bonds.position[connection];
  return pull(connection, sites, box) * norm(box.nearest(sites.x[bonds.sites[1][k]] - sites.x[bonds.sites[0][k]]));
}

std::optional<BadForce> Bonds::find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                        std::span<const double> parameters) {
  Kernel& kernel = *kernel_;
  BondBlock& block = kernel.plain.front();
  block.law.set(instant, parameters);
  std::optional<std::uint32_t> first;  // in the order of BondList
  const std::size_t outputs = kernel.law->kind == LawKind::central ? 1
                              : kernel.law->kind == LawKind::pair  ? 3
                                                                   : 3 * kernel.count();
  for (std::size_t begin = 0; begin < kernel.bonds.n; begin += block_size) {
    const Stretch at{begin, std::min(block_size, kernel.bonds.n - begin)};
    kernel.gather(block, at, sites, box);
    block.law.run(static_cast<int>(at.n), sites);
    for (std::size_t k = 0; k < at.n; k++) {
      double sum = kernel.law->kind == LawKind::many ? 0.0 : dot(block.d[k], zero3());
      for (std::size_t c = 0; c < outputs; c++) sum += block.law.output(c)[k] * 0.0;
      const std::uint32_t connection = kernel.bonds.connection[begin + k];
      if (sum != 0.0 && connection < first.value_or(static_cast<std::uint32_t>(-1))) first = connection;
    }
  }
  if (!first) return std::nullopt;
  BadForce bad;
  bad.count = kernel.law->count;
  for (std::size_t who = 0; who < kernel.count(); who++)
    bad.sites[who] = kernel.bonds.sites[who][kernel.bonds.position[*first]];
  bad.distance = norm(box.nearest(sites.x[bad.sites[1]] - sites.x[bad.sites[0]]));
  return bad;
}

}  // namespace pantin
