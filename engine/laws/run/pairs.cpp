#include "laws/run/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.hpp"
#include "base/compensated.hpp"
#include "laws/run/pair_block.hpp"
#include "laws/run/pair_slopes.hpp"
#include "laws/velocity_slopes.hpp"

namespace pantin {

namespace {

constexpr std::size_t serial_slots = 4096;  // fewer are not worth sharing out
enum class Roles { both, first_only, exchanged };

template <Roles roles>
void scatter_central(const PairBlock& block, const Vec3* x, Vec3* force) {
  const double* w = block.law.output(0);
  const std::uint32_t* j = block.neighbours.data();
  const auto* part = block.parts.data();
  for (const auto* const last = part + block.part_count; part != last; part++) {
    const Vec3 from = part->from;
    const auto pull = [&] {
      const std::uint32_t to = *j++;
      const Vec3 f = (from - x[to]) * *w++;
      if constexpr (roles != Roles::first_only) force[to] += f;
      return f;
    };
    Vec3 sum = zero3(), other_sum = zero3();
    int left = part->count;
    for (; left > 1; left -= 2) {
      sum += pull();
      other_sum += pull();
    }
    if (left > 0) sum += pull();
    if constexpr (roles != Roles::exchanged) force[part->site] -= sum + other_sum;
  }
}

/// With the roles exchanged the outputs are forces on the neighbours.
template <Roles roles>
void scatter_forces(const PairBlock& block, Vec3* force) {
  const double *fx = block.law.output(0), *fy = block.law.output(1), *fz = block.law.output(2);
  const std::uint32_t* j = block.neighbours.data();
  block.each_part([&](const PairBlock::Part& part, int at) {
    Vec3 sum = zero3();
    for (int k = at; k < at + part.count; k++) {
      const Vec3 f = vec(fx[k], fy[k], fz[k]);
      if constexpr (roles != Roles::exchanged) sum += f;
      if constexpr (roles == Roles::both) force[j[k]] -= f;
      if constexpr (roles == Roles::exchanged) force[j[k]] += f;
    }
    force[part.site] += sum;
  });
}

template <Roles roles>
void scatter(const PairBlock& block, bool central, const Vec3* x, Vec3* force) {
  if (central)
    scatter_central<roles>(block, x, force);
  else
    scatter_forces<roles>(block, force);
}

void add_energy(const PairBlock& block, const double* energy, CompensatedLanes& sum) {
  for (int k = 0; k < block.count; k += 4) {
    Vec3 four = zero3();
    for (int lane = 0; lane < std::min(4, block.count - k); lane++) four[lane] = energy[k + lane];
    sum.add(four);
  }
}

}  // namespace

struct Pairs::Kernel {
  std::shared_ptr<const Law> law;
  std::vector<std::string> names;
  std::size_t workers = 1;
  std::vector<PairBlock> plain, energetic;  // one for each worker; none in a copy that has not run yet
  std::vector<PairBlock> sloped;            // one of a law of velocity, once its derivatives are asked for
  bool linear = false;                      // in velocity
  std::size_t radius = 0;                   // column of a touching law
  std::vector<CompensatedSum> energies;     // of slabs

  void make_blocks();

  bool central() const { return law->kind == LawKind::central; }
  PairLimits limits(const NeighbourList& rows) const;
  /// Calls each(block, exchanged) for every block of a slab, when the law has been run.
  template <class Each>
  void run(PairBlock& block, const Sites& sites, const NeighbourList& rows, const Slab& slab, Each each) const;
  void add_slab(PairBlock& block, Sites& sites, const NeighbourList& rows, const Slab& slab,
                CompensatedSum* energy) const;
  double add(std::vector<PairBlock>& blocks, Sites& sites, const NeighbourList& rows, const Instant& instant,
             std::span<const double> parameters, Workers& shared, bool with_energy);
};

PairLimits Pairs::Kernel::limits(const NeighbourList& rows) const {
  const double c = rows.cutoff();
  return {c < infinity ? c * c : 1e300, rows.least_distance2()};
}

template <class Each>
void Pairs::Kernel::run(PairBlock& block, const Sites& sites, const NeighbourList& rows, const Slab& slab,
                        Each each) const {
  const PairLimits limit = limits(rows);
  const double* radii = law->touching ? sites.attributes[radius].data() : nullptr;
  RowCursor at;
  while (at.row < slab.rows.size()) {
    block.gather(sites, slab, rows.shifts(), limit, radii, at);
    block.law.run(block.count, sites);
    each(block, false);
    if (!law->one_sided || !rows.within()) continue;
    block.exchange_roles(sites);
    block.law.run(block.count, sites);
    each(block, true);
  }
}

void Pairs::Kernel::add_slab(PairBlock& block, Sites& sites, const NeighbourList& rows, const Slab& slab,
                             CompensatedSum* energy) const {
  Vec3* force = law->has_energy() ? sites.force.data() : sites.nonconservative_force.data();
  const Vec3* x = sites.x.data();
  const std::size_t energy_output = central() ? 1 : 3;
  CompensatedLanes sum;
  run(block, sites, rows, slab, [&](const PairBlock& made, bool exchanged) {
    if (exchanged)
      scatter<Roles::exchanged>(made, central(), x, force);
    else if (law->one_sided)
      scatter<Roles::first_only>(made, central(), x, force);
    else
      scatter<Roles::both>(made, central(), x, force);
    if (energy != nullptr) add_energy(made, made.law.output(energy_output), sum);
  });
  if (energy != nullptr) *energy = sum.total();
}

double Pairs::Kernel::add(std::vector<PairBlock>& blocks, Sites& sites, const NeighbourList& rows,
                          const Instant& instant, std::span<const double> parameters, Workers& shared,
                          bool with_energy) {
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
      shared.run(phase.size(), task);
    for (std::size_t k = 0; with_energy && k < phase.size(); k++) total.add(energies[k]);
  }
  return total.value();
}

void Pairs::Kernel::make_blocks() {
  for (std::size_t k = 0; k < workers; k++) {
    plain.emplace_back(LawBlock(*law, false, names));
    if (law->has_energy()) energetic.emplace_back(LawBlock(*law, true, names));
  }
}

Pairs::Pairs(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : kernel_(std::make_unique<Kernel>()) {
  assume(law->kind == LawKind::central || law->kind == LawKind::pair);
  kernel_->law = std::move(law);
  kernel_->names.assign(names.begin(), names.end());
  kernel_->workers = static_cast<std::size_t>(workers.count());
  kernel_->make_blocks();
  const Law& made = *kernel_->law;
  if (!made.touching) return;
  const auto found = std::find(names.begin(), names.end(), "radius");
  require(found != names.end(), made.name, ": there is no attribute \"radius\"");
  kernel_->radius = static_cast<std::size_t>(found - names.begin());
}

Pairs::~Pairs() = default;
Pairs::Pairs(const Pairs& other) : kernel_(std::make_unique<Kernel>()) {
  kernel_->law = other.kernel_->law;
  kernel_->names = other.kernel_->names;
  kernel_->workers = other.kernel_->workers;
  kernel_->radius = other.kernel_->radius;
}
Pairs::Pairs(Pairs&&) noexcept = default;
Pairs& Pairs::operator=(Pairs&&) noexcept = default;

void Pairs::add_forces(Sites& sites, const NeighbourList& rows, const Instant& instant,
                       std::span<const double> parameters, Workers& workers) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  kernel_->add(kernel_->plain, sites, rows, instant, parameters, workers, false);
}

double Pairs::add_forces_and_energy(Sites& sites, const NeighbourList& rows, const Instant& instant,
                                    std::span<const double> parameters, Workers& workers) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  const bool has = kernel_->law->has_energy();
  return kernel_->add(has ? kernel_->energetic : kernel_->plain, sites, rows, instant, parameters, workers, has);
}

bool Pairs::list_slopes(const Sites& sites, const NeighbourList& rows, const Instant& instant,
                        std::span<const double> parameters, std::vector<VelocityPair>& to) {
  Kernel& kernel = *kernel_;
  if (kernel.sloped.empty()) {
    const std::shared_ptr<const Law> law = with_velocity_slopes(*kernel.law);
    kernel.linear = is_linear_in_velocity(*law);
    kernel.sloped.emplace_back(LawBlock(*law, false, kernel.names));
  }
  PairBlock& block = kernel.sloped.front();
  block.law.set(instant, parameters);
  PairSlopes slopes(*kernel.law, sites, to);
  std::vector<std::uint32_t> of_row(LawBlock::most);
  const auto take = [&](PairBlock& made, bool exchanged) {
    made.each_part(
        [&](const PairBlock::Part& part, int at) { std::fill_n(of_row.begin() + at, part.count, part.site); });
    slopes.take(
        made.law, static_cast<std::size_t>(made.count), made.d.data(), made.u.data(),
        [&](std::size_t k) {
          return exchanged ? std::pair(made.neighbours[k], of_row[k]) : std::pair(of_row[k], made.neighbours[k]);
        },
        exchanged ? -1.0 : 1.0);
  };
  for (const std::vector<Slab>& phase : rows.phases())
    for (const Slab& slab : phase) kernel.run(block, sites, rows, slab, take);
  return kernel.linear;
}

std::optional<BadForce> Pairs::find_bad(const Sites& sites, const NeighbourList& rows, const Instant& instant,
                                        std::span<const double> parameters) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  PairBlock& block = kernel_->plain.front();
  block.law.set(instant, parameters);
  const std::size_t outputs = kernel_->central() ? 1 : 3;
  std::optional<BadForce> bad;
  const auto look = [&](const PairBlock& made, bool exchanged) {
    made.each_part([&](const PairBlock::Part& part, int at) {
      for (auto k = static_cast<std::size_t>(at); k < static_cast<std::size_t>(at + part.count) && !bad; k++) {
        const std::uint32_t i = part.site, j = made.neighbours[k];
        const Vec3 d = sites.x[j] - part.from;
        double sum = dot(d, zero3());
        for (std::size_t c = 0; c < outputs; c++) sum += made.law.output(c)[k] * 0.0;
        if (sum != 0.0) bad = BadForce{{exchanged ? j : i, exchanged ? i : j}, 2, norm(d)};
      }
    });
  };
  for (const std::vector<Slab>& phase : rows.phases())
    for (const Slab& slab : phase)
      if (!bad) kernel_->run(block, sites, rows, slab, look);
  return bad;
}

}  // namespace pantin
