#include "laws/run/law_on_sites.hpp"

#include <algorithm>
#include <cstring>

#include "laws/velocity_slopes.hpp"

namespace pantin {

namespace {

void add_four_at_a_time(const double* energy, int n, CompensatedLanes& sum) {
  Vec3 four = zero3();
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    std::memcpy(&four, energy + k, sizeof four);
    sum.add(four);
  }
  if (k == n) return;
  four = zero3();
  for (int lane = 0; lane < n - k; lane++) four[lane] = energy[k + lane];
  sum.add(four);
}

/// Makes a block show all that it can.
LawBlock with_all(LawBlock law) {
  law.wants_sites = law.wants_displacement = law.wants_motion = true;
  return law;
}

VelocityPair pair_of(const Block& block, const Law& law, std::size_t k) {
  VelocityPair pair;
  pair.a = block.law.sites[0][k];
  pair.b = block.law.sites[1][k];
  pair.one_sided = law.one_sided;
  pair.workless = law.workless;
  pair.force = block.force[k];
  pair.at = block.u[k] * block.sign;
  pair.slope = block.slope[k];
  return pair;
}

}  // namespace

LawOnSites::LawOnSites(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : law_(std::move(law)), names_(names.begin(), names.end()), workers_(static_cast<std::size_t>(workers.count())) {}

LawOnSites::LawOnSites(const LawOnSites& other)
    : asked_(other.asked_),
      law_(other.law_),
      names_(other.names_),
      workers_(other.workers_),
      uniform_(other.uniform_) {}
LawOnSites::LawOnSites(LawOnSites&&) noexcept = default;
LawOnSites& LawOnSites::operator=(LawOnSites&&) noexcept = default;
LawOnSites::~LawOnSites() = default;

void LawOnSites::make_blocks() {
  for (const bool with_energy : {false, true}) {
    if (with_energy && !law_->has_energy()) continue;
    const LawProgram program(*law_, with_energy, uniform_);
    Blocks& made = with_energy ? energetic_ : plain_;
    for (std::size_t k = 0; k < workers_; k++) made.push_back(make_block(LawBlock(*law_, program, names_)));
    speed_up(made, program.program);
  }
}

void LawOnSites::drop_blocks(bool own_parameters) {
  uniform_ = {!own_parameters};
  plain_.clear();
  energetic_.clear();
  sloped_.clear();
}

LawOnSites::Blocks& LawOnSites::blocks(bool with_energy) {
  if (plain_.empty()) make_blocks();
  return with_energy ? energetic_ : plain_;
}

std::vector<Task> LawOnSites::in_order() const {
  std::vector<Task> list;
  for (std::size_t phase = 0; phase < phases(); phase++)
    for (std::size_t k = 0; k < tasks(phase); k++) list.push_back(task(phase, k));
  return list;
}

template <class Use>
void LawOnSites::share_out(Blocks& blocks, const Instant& instant, std::span<const double> parameters, Workers& workers,
                           Use use) {
  const bool serial = law_->called || is_small();
  for (std::size_t k = 0; k < (serial ? 1 : blocks.size()); k++) blocks[k]->law.set(instant, parameters);
  std::size_t before = 0;
  for (std::size_t phase = 0; phase < phases(); phase++) {
    const auto run = [&](std::size_t k, int worker) {
      use(*blocks[static_cast<std::size_t>(worker)], task(phase, k), before + k);
    };
    const std::size_t count = tasks(phase);
    energies_.resize(std::max(energies_.size(), before + count));
    if (serial)
      for (std::size_t k = 0; k < count; k++) run(k, 0);
    else
      workers.run(count, run);
    before += count;
  }
}

CompensatedSum LawOnSites::add_task(Block& block, const Task& task, Sites& sites, const Box& box) {
  Vec3* const force = law_->has_energy() ? sites.force.data() : sites.nonconservative_force.data();
  const std::size_t energy = force_outputs(*law_);
  CompensatedSum sum;
  CompensatedLanes lanes;
  each_block(block, task, sites, box, [&](const Block& made) {
    scatter(made, sites, force);
    if (!asked_.with_energy) return;
    const double* each = made.law.output(energy);
    if (made.in_lanes) return add_four_at_a_time(each, made.count, lanes);
    for (int k = 0; k < made.count; k++) sum.add(each[k]);
  });
  return block.in_lanes ? lanes.total() : sum;
}

double LawOnSites::add(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                       Workers& workers, bool with_energy) {
  asked_.instant = instant;
  asked_.parameters.assign(parameters.begin(), parameters.end());
  asked_.with_energy = with_energy;
  asked_.is_new = true;
  energies_.clear();
  share_out(blocks(with_energy), instant, parameters, workers,
            [&](Block& block, const Task& task, std::size_t k) { energies_[k] = add_task(block, task, sites, box); });
  CompensatedSum total;
  for (const CompensatedSum& energy : energies_) total.add(energy);
  return total.value();
}

void LawOnSites::add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                            Workers& workers) {
  add(sites, box, instant, parameters, workers, false);
}

double LawOnSites::add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant,
                                         std::span<const double> parameters, Workers& workers) {
  return add(sites, box, instant, parameters, workers, law_->has_energy());
}

void LawOnSites::make_sloped() {
  const std::shared_ptr<const Law> law = with_velocity_slopes(*law_);
  linear_ = is_linear_in_velocity(*law);
  const LawProgram program(*law, false, uniform_);
  for (std::size_t k = 0; k < (law_->kind == LawKind::point ? workers_ : 1); k++)
    sloped_.push_back(make_block(with_all(LawBlock(*law, program, names_))));
}

bool LawOnSites::add_slopes(const Sites& sites, const Box& box, const Instant& instant,
                            std::span<const double> parameters, Workers& workers, SiteSlopes& on_sites,
                            std::vector<VelocityPair>& pairs) {
  if (sloped_.empty()) make_sloped();
  const double difference = law_->called ? velocity_difference(sites) : 0.0;
  const auto ask = [&](Block& block, const Task& task, auto take) {
    each_block(block, task, sites, box, [&](Block& made) {
      made.find_slopes(*law_, sites, difference);
      for (std::size_t k = 0; k < static_cast<std::size_t>(made.count); k++) take(made, k);
    });
  };
  if (law_->kind == LawKind::point) {
    share_out(sloped_, instant, parameters, workers, [&](Block& block, const Task& task, std::size_t) {
      ask(block, task, [&](const Block& made, std::size_t k) {
        const std::uint32_t site = made.law.sites[0][k];
        on_sites.force[site] += made.force[k];
        on_sites.slope[site] += made.slope[k];
      });
    });
    return linear_;
  }
  sloped_.front()->law.set(instant, parameters);
  for (const Task& task : in_order())
    ask(*sloped_.front(), task, [&](const Block& made, std::size_t k) { pairs.push_back(pair_of(made, *law_, k)); });
  return linear_;
}

std::optional<BadForce> LawOnSites::find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                             std::span<const double> parameters) const {
  const std::unique_ptr<Block> block =
      make_block(with_all(LawBlock(*law_, LawProgram(*law_, false, uniform_), names_)));
  block->law.set(instant, parameters);
  std::optional<BadForce> bad;
  std::size_t least = 0;
  const auto look = [&](const Block& made, std::size_t k) {
    double sum = made.d.size() == 0 ? 0.0 : dot(made.d[k], zero3());
    for (std::size_t c = 0; c < force_outputs(*law_); c++) sum += made.law.output(c)[k] * 0.0;
    if (sum == 0.0 || (bad && number(made, k) >= least)) return;
    least = number(made, k);
    bad.emplace();
    bad->count = law_->count;
    for (std::size_t who = 0; who < static_cast<std::size_t>(bad->count); who++)
      bad->sites[who] = made.law.sites[who][k];
    if (bad->count > 1) bad->distance = norm(box.nearest(sites.x[bad->sites[1]] - sites.x[bad->sites[0]]));
  };
  for (const Task& task : in_order())
    each_block(*block, task, sites, box, [&](const Block& made) {
      for (std::size_t k = 0; k < static_cast<std::size_t>(made.count); k++) look(made, k);
    });
  return bad;
}

}  // namespace pantin
