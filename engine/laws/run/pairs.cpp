#include "laws/run/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "laws/run/pair_block.hpp"
#include "laws/run/pair_code.hpp"

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

}  // namespace

Pairs::Pairs(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : LawOnSites(std::move(law), names, workers) {
  assume(this->law().kind == LawKind::central || this->law().kind == LawKind::pair);
  make_blocks();
  if (!this->law().touching) return;
  const auto found = std::find(names.begin(), names.end(), "radius");
  require(found != names.end(), this->law().name, ": there is no attribute \"radius\"");
  radius_ = static_cast<std::size_t>(found - names.begin());
}

bool Pairs::is_small() const { return neighbours.slots() < serial_slots; }

Task Pairs::task(std::size_t phase, std::size_t number) const {
  const Slab& slab = neighbours.phases()[phase][number];
  return {.end = slab.rows.size(), .slab = &slab};
}

std::unique_ptr<Block> Pairs::make_block(LawBlock made) const { return std::make_unique<PairBlock>(std::move(made)); }

void Pairs::speed_up(Blocks& made, const Program& program) const {
  const std::shared_ptr<const PairCode> code = law().called ? nullptr : PairCode::of(law(), program);
  for (const auto& block : made) {
    static_cast<PairBlock&>(*block).code = code;
    block->in_one_pass = code != nullptr;
  }
}

void Pairs::gather(Block& to, Task& task, const Sites& sites, const Box& /*box*/) const {
  auto& block = static_cast<PairBlock&>(to);
  if (std::exchange(task.exchange, false)) return block.exchange_roles(sites);
  const double c = neighbours.cutoff();
  const PairLimits limits{c < infinity ? c * c : 1e300, neighbours.least_distance2()};
  const double* radii = law().touching ? sites.attributes[radius_].data() : nullptr;
  block.gather(sites, neighbours.shifts(), limits, radii, task);
  task.exchange = law().one_sided && neighbours.within();
}

void Pairs::scatter(const Block& made, const Sites& sites, Vec3* force) {
  const auto& block = static_cast<const PairBlock&>(made);
  if (block.code) return block.code->run(block, sites, force);
  const bool central = law().kind == LawKind::central;
  const Vec3* x = sites.x.data();
  if (block.sign < 0.0)
    pantin::scatter<Roles::exchanged>(block, central, x, force);
  else if (law().one_sided)
    pantin::scatter<Roles::first_only>(block, central, x, force);
  else
    pantin::scatter<Roles::both>(block, central, x, force);
}

}  // namespace pantin
