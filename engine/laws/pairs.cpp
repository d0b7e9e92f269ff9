#include "laws/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.hpp"
#include "base/compensated.hpp"
#include "laws/block.hpp"

namespace pantin {

namespace {

constexpr std::size_t serial_slots = 4096;  // fewer are not worth sharing out
constexpr int most_spans = LawBlock::most / 4;

/// A row, or what of it is in a block.
struct RowPart {
  std::uint32_t site, shift;
  const std::uint32_t* list;
  int count;
};

/// The squared lengths of four vectors.
inline Vec3 lengths2(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  a *= a;
  b *= b;
  c *= c;
  d *= d;
  const Vec3 ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Vec3 cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

Vec3 load(const double* from) { return *reinterpret_cast<const Vec3*>(from); }
void store(double* to, Vec3 v) { *reinterpret_cast<Vec3*>(to) = v; }
Vec3 all(double x) { return Vec3{x, x, x, x}; }

enum class Roles { both, first_only, exchanged };

struct Limits {
  double cutoff2 = 0.0;  ///< [m²] for pairs that are not nearer the law is evaluated here, and the result not used
  double least2 = 0.0;   ///< [m²]
};

/// A block with the vectors that its forces are along.
struct PairBlock {
  LawBlock law;
  AlignedVector<Vec3> d;  ///< [m] from a to b
  AlignedVector<Vec3> u;  ///< [m/s] velocity of b less that of a
  std::array<RowPart, most_spans> parts;
  int part_count = 0, count = 0;

  explicit PairBlock(LawBlock made) : law(std::move(made)) {
    d.assign(LawBlock::most, zero3());
    u.assign(law.wants_motion ? LawBlock::most : 0, zero3());
  }
};

/// Where the next block of a slab begins.
struct Cursor {
  std::size_t row = 0;
  std::uint32_t offset = 0;
};

void take_parts(PairBlock& block, const Slab& slab, Cursor& at) {
  block.part_count = block.count = 0;
  while (at.row < slab.rows.size() && block.count < LawBlock::most) {
    const NeighbourRow& row = slab.rows[at.row];
    const int count = std::min(static_cast<int>(row.count - at.offset), LawBlock::most - block.count);
    block.parts[static_cast<std::size_t>(block.part_count++)] = {row.site, row.shift, slab.list + row.begin + at.offset,
                                                                 count};
    block.count += count;
    at.offset += static_cast<std::uint32_t>(count);
    if (at.offset == row.count) at = {at.row + 1, 0};
  }
}

void gather_places(PairBlock& block, const Sites& sites, const Vec3* shifts, const Limits& limits) {
  const Vec3* x = sites.x.data();
  Vec3* d = block.d.data();
  double* r2 = block.law.distance2;
  const Vec3 cutoff2 = all(limits.cutoff2), least2 = all(limits.least2);
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    const Vec3 from = x[part.site] - shifts[part.shift];
    const std::uint32_t* j = part.list;
    for (int k = 0; k < part.count; k += 4) {
      const Vec3 a = x[j[k]] - from, b = x[j[k + 1]] - from, c = x[j[k + 2]] - from, e = x[j[k + 3]] - from;
      d[k] = a;
      d[k + 1] = b;
      d[k + 2] = c;
      d[k + 3] = e;
      Vec3 length2 = lengths2(a, b, c, e);
      length2 = length2 > least2 ? length2 : least2;
      store(r2 + k, length2 < cutoff2 ? length2 : cutoff2);
    }
    d += part.count;
    r2 += part.count;
  }
}

void gather_motion(PairBlock& block, const Sites& sites) {
  const Vec3* v = sites.v.data();
  std::size_t at = 0;
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    for (int k = 0; k < part.count; k++) block.u[at++] = v[part.list[k]] - v[part.site];
  }
  if (double* approach = block.law.approach)
    for (std::size_t k = 0; k < at; k++) approach[k] = dot(block.d[k], block.u[k]);
}

void gather_components(const AlignedVector<Vec3>& from, int n, const LawBlock::Vector& to, double sign) {
  for (int c = 0; c < 3; c++)
    if (double* column = to[static_cast<std::size_t>(c)])
      for (int k = 0; k < n; k++) column[k] = sign * from[static_cast<std::size_t>(k)][c];
}

/// With the roles exchanged the row's site is b.
void gather_attributes(PairBlock& block, const Sites& sites, bool exchanged) {
  for (const LawBlock::Attribute& attribute : block.law.attributes) {
    const double* column = sites.attributes[attribute.column].data();
    const bool of_row = (attribute.who == 0) != exchanged;
    double* to = attribute.to;
    for (int p = 0; p < block.part_count; p++) {
      const RowPart& part = block.parts[static_cast<std::size_t>(p)];
      if (of_row)
        std::fill_n(to, part.count, column[part.site]);
      else
        for (int k = 0; k < part.count; k++) to[k] = column[part.list[k]];
      to += part.count;
    }
  }
}

void gather_sites(PairBlock& block, bool exchanged) {
  std::uint32_t *of_row = block.law.sites[exchanged ? 1 : 0], *of_list = block.law.sites[exchanged ? 0 : 1];
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    of_row = std::fill_n(of_row, part.count, part.site);
    of_list = std::copy_n(part.list, part.count, of_list);
  }
}

/// Those that do not touch are taken to be beyond the cutoff.
void part_untouching(PairBlock& block, const AlignedVector<double>& radius, const Limits& limits) {
  double* r2 = block.law.distance2;
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    for (int k = 0; k < part.count; k++) {
      const double reach = radius[part.site] + radius[part.list[k]];
      r2[k] = r2[k] < reach * reach ? r2[k] : limits.cutoff2;
    }
    r2 += part.count;
  }
}

template <Roles roles>
void scatter_central(const PairBlock& block, const double* w, double cutoff2, Vec3* force) {
  const Vec3* d = block.d.data();
  const double* r2 = block.law.distance2;
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    const std::uint32_t* j = part.list;
    Vec3 sum = zero3(), other_sum = zero3();
    for (int k = 0; k < part.count; k += 4) {
      const Vec3 pull = load(r2 + k) < all(cutoff2) ? load(w + k) : zero3();
      const Vec3 a = d[k] * pull[0], b = d[k + 1] * pull[1], c = d[k + 2] * pull[2], e = d[k + 3] * pull[3];
      if constexpr (roles != Roles::exchanged) {
        sum += a;
        other_sum += b;
        sum += c;
        other_sum += e;
      }
      if constexpr (roles != Roles::first_only) {
        force[j[k]] -= a;
        force[j[k + 1]] -= b;
        force[j[k + 2]] -= c;
        force[j[k + 3]] -= e;
      }
    }
    if constexpr (roles != Roles::exchanged) force[part.site] += sum + other_sum;
    d += part.count;
    r2 += part.count;
    w += part.count;
  }
}

/// With the roles exchanged the outputs are forces on the neighbours.
template <Roles roles>
void scatter_forces(const PairBlock& block, double cutoff2, Vec3* force) {
  const double *r2 = block.law.distance2, *fx = block.law.output(0), *fy = block.law.output(1),
               *fz = block.law.output(2);
  int at = 0;
  for (int p = 0; p < block.part_count; p++) {
    const RowPart& part = block.parts[static_cast<std::size_t>(p)];
    Vec3 sum = zero3();
    for (int k = 0; k < part.count; k++, at++) {
      const Vec3 f = r2[at] < cutoff2 ? vec(fx[at], fy[at], fz[at]) : zero3();
      if constexpr (roles != Roles::exchanged) sum += f;
      if constexpr (roles == Roles::both) force[part.list[k]] -= f;
      if constexpr (roles == Roles::exchanged) force[part.list[k]] += f;
    }
    force[part.site] += sum;
  }
}

template <Roles roles>
void scatter(const PairBlock& block, bool central, double cutoff2, Vec3* force) {
  if (central)
    scatter_central<roles>(block, block.law.output(0), cutoff2, force);
  else
    scatter_forces<roles>(block, cutoff2, force);
}

void add_energy(const PairBlock& block, const double* energy, double cutoff2, CompensatedLanes& sum) {
  for (int k = 0; k < block.count; k += 4)
    sum.add(load(block.law.distance2 + k) < all(cutoff2) ? load(energy + k) : zero3());
}

}  // namespace

struct Pairs::Kernel {
  std::shared_ptr<const Law> law;
  std::vector<PairBlock> plain, energetic;  // one for each worker
  std::size_t radius = 0;                   // column of a touching law
  std::vector<CompensatedSum> energies;     // of slabs

  bool central() const { return law->kind == LawKind::central; }
  Limits limits(const Rows& rows) const;
  void gather(PairBlock& block, const Sites& sites, const Rows& rows, const Limits& limits) const;
  void exchange_roles(PairBlock& block, const Sites& sites) const;
  /// Calls each(block, exchanged) for every block of a slab, when the law has been run.
  template <class Each>
  void run(PairBlock& block, const Sites& sites, const Rows& rows, const Slab& slab, Each each) const;
  void add_slab(PairBlock& block, Sites& sites, const Rows& rows, const Slab& slab, CompensatedSum* energy) const;
  double add(std::vector<PairBlock>& blocks, Sites& sites, const Rows& rows, const Instant& instant,
             std::span<const double> parameters, Workers& workers, bool with_energy);
};

Limits Pairs::Kernel::limits(const Rows& rows) const {
  const double c = rows.cutoff();
  return {c < infinity ? c * c : 1e300, rows.least_distance2()};
}

void Pairs::Kernel::gather(PairBlock& block, const Sites& sites, const Rows& rows, const Limits& limits) const {
  gather_places(block, sites, rows.shifts(), limits);
  if (law->touching) part_untouching(block, sites.attributes[radius], limits);
  if (block.law.wants_motion) gather_motion(block, sites);
  if (block.law.wants_displacement) gather_components(block.d, block.count, block.law.displacement, 1.0);
  if (block.law.wants_motion) gather_components(block.u, block.count, block.law.relative_velocity, 1.0);
  gather_attributes(block, sites, false);
  if (block.law.wants_sites) gather_sites(block, false);
}

void Pairs::Kernel::exchange_roles(PairBlock& block, const Sites& sites) const {
  if (block.law.wants_displacement) gather_components(block.d, block.count, block.law.displacement, -1.0);
  if (block.law.wants_motion) gather_components(block.u, block.count, block.law.relative_velocity, -1.0);
  gather_attributes(block, sites, true);
  if (block.law.wants_sites) gather_sites(block, true);
}

template <class Each>
void Pairs::Kernel::run(PairBlock& block, const Sites& sites, const Rows& rows, const Slab& slab, Each each) const {
  const Limits limit = limits(rows);
  Cursor at;
  while (at.row < slab.rows.size()) {
    take_parts(block, slab, at);
    gather(block, sites, rows, limit);
    block.law.run(block.count, sites, limit.cutoff2);
    each(block, false);
    if (!law->one_sided || !rows.within()) continue;
    exchange_roles(block, sites);
    block.law.run(block.count, sites, limit.cutoff2);
    each(block, true);
  }
}

void Pairs::Kernel::add_slab(PairBlock& block, Sites& sites, const Rows& rows, const Slab& slab,
                             CompensatedSum* energy) const {
  Vec3* force = law->has_energy() ? sites.force.data() : sites.open_force.data();
  const double cutoff2 = limits(rows).cutoff2;
  const std::size_t energy_output = central() ? 1 : 3;
  CompensatedLanes sum;
  run(block, sites, rows, slab, [&](const PairBlock& made, bool exchanged) {
    if (exchanged)
      scatter<Roles::exchanged>(made, central(), cutoff2, force);
    else if (law->one_sided)
      scatter<Roles::first_only>(made, central(), cutoff2, force);
    else
      scatter<Roles::both>(made, central(), cutoff2, force);
    if (energy != nullptr) add_energy(made, made.law.output(energy_output), cutoff2, sum);
  });
  if (energy != nullptr) *energy = sum.total();
}

double Pairs::Kernel::add(std::vector<PairBlock>& blocks, Sites& sites, const Rows& rows, const Instant& instant,
                          std::span<const double> parameters, Workers& workers, bool with_energy) {
  const bool serial = law->called || rows.slots() < serial_slots;
  for (std::size_t k = 0; k < (serial ? 1 : blocks.size()); k++) blocks[k].law.set(instant, parameters);
  CompensatedSum total;
  for (const std::vector<Slab>& phase : rows.phases()) {
    energies.resize(std::max(energies.size(), phase.size()));
    const auto task = [&](std::size_t k, int worker) {
      add_slab(blocks[static_cast<std::size_t>(worker)], sites, rows, phase[k], with_energy ? &energies[k] : nullptr);
    };
    if (serial)
      for (std::size_t k = 0; k < phase.size(); k++) task(k, 0);
    else
      workers.run(phase.size(), task);
    for (std::size_t k = 0; with_energy && k < phase.size(); k++) total.add(energies[k]);
  }
  return total.value();
}

Pairs::Pairs(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : kernel_(std::make_unique<Kernel>()) {
  assume(law->kind == LawKind::central || law->kind == LawKind::pair);
  kernel_->law = std::move(law);
  const Law& made = *kernel_->law;
  for (int k = 0; k < workers.count(); k++) {
    kernel_->plain.emplace_back(LawBlock(made, false, names));
    if (made.has_energy()) kernel_->energetic.emplace_back(LawBlock(made, true, names));
  }
  if (!made.touching) return;
  const auto found = std::find(names.begin(), names.end(), "radius");
  require(found != names.end(), made.name, ": there is no attribute \"radius\"");
  kernel_->radius = static_cast<std::size_t>(found - names.begin());
}

Pairs::~Pairs() = default;
Pairs::Pairs(Pairs&&) noexcept = default;
Pairs& Pairs::operator=(Pairs&&) noexcept = default;

void Pairs::add_forces(Sites& sites, const Rows& rows, const Instant& instant, std::span<const double> parameters,
                       Workers& workers) {
  kernel_->add(kernel_->plain, sites, rows, instant, parameters, workers, false);
}

double Pairs::add_forces_and_energy(Sites& sites, const Rows& rows, const Instant& instant,
                                    std::span<const double> parameters, Workers& workers) {
  const bool has = kernel_->law->has_energy();
  return kernel_->add(has ? kernel_->energetic : kernel_->plain, sites, rows, instant, parameters, workers, has);
}

std::optional<BadForce> Pairs::find_bad(const Sites& sites, const Rows& rows, const Instant& instant,
                                        std::span<const double> parameters) {
  PairBlock& block = kernel_->plain.front();
  block.law.set(instant, parameters);
  const double cutoff2 = kernel_->limits(rows).cutoff2;
  const std::size_t outputs = kernel_->central() ? 1 : 3;
  std::optional<BadForce> bad;
  const auto look = [&](const PairBlock& made, bool exchanged) {
    std::size_t at = 0;
    for (std::size_t p = 0; p < static_cast<std::size_t>(made.part_count); p++)
      for (int k = 0; k < made.parts[p].count && !bad; k++, at++) {
        double sum = dot(made.d[at], zero3());
        for (std::size_t c = 0; c < outputs; c++) sum += made.law.output(c)[at] * 0.0;
        if (sum == 0.0 || !(made.law.distance2[at] < cutoff2)) continue;
        const std::uint32_t i = made.parts[p].site, j = made.parts[p].list[k];
        bad = BadForce{{exchanged ? j : i, exchanged ? i : j}, 2, norm(made.d[at])};
      }
  };
  for (const std::vector<Slab>& phase : rows.phases())
    for (const Slab& slab : phase)
      if (!bad) kernel_->run(block, sites, rows, slab, look);
  return bad;
}

}  // namespace pantin
