#include "laws/run/fields.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "base/compensated.hpp"
#include "laws/run/block.hpp"
#include "laws/velocity_slopes.hpp"

namespace pantin {

namespace {

constexpr std::size_t block_size = LawBlock::most, task_size = 4 * block_size;

/// Places are seen within the box.
void gather(LawBlock& law, std::span<const std::uint32_t> members, const Sites& sites, const Box& box) {
  for (std::size_t k = 0; k < members.size(); k++) {
    const Vec3 x = box.wrapped(sites.x[members[k]]), v = sites.v[members[k]];
    for (std::size_t c = 0; c < 3; c++) {
      if (law.position[0][c] != nullptr) law.position[0][c][k] = x[static_cast<int>(c)];
      if (law.velocity[0][c] != nullptr) law.velocity[0][c][k] = v[static_cast<int>(c)];
    }
  }
  for (const LawBlock::Attribute& attribute : law.attributes) {
    const double* column = sites.attributes[attribute.column].data();
    for (std::size_t k = 0; k < members.size(); k++) attribute.to[k] = column[members[k]];
  }
  if (law.wants_sites) std::copy(members.begin(), members.end(), law.sites[0]);
}

}  // namespace

struct Fields::Kernel {
  std::shared_ptr<const Law> law;
  std::vector<std::string> names;
  std::size_t workers = 1;
  std::vector<LawBlock> plain, energetic;  // one for each worker; none in a copy that has not run yet
  std::vector<LawBlock> sloped;            // the same of a law of velocity, from when its derivatives are asked for
  bool linear = false;                     // in velocity
  std::vector<std::uint32_t> members;
  std::vector<CompensatedSum> energies;

  void make_blocks();

  /// Calls each(block, members of it) when the law has been run, for the blocks of one task.
  template <class Each>
  void run(LawBlock& block, std::size_t task, const Sites& sites, const Box& box, Each each) const {
    const std::size_t end = std::min((task + 1) * task_size, members.size());
    for (std::size_t begin = task * task_size; begin < end; begin += block_size) {
      const auto some = std::span(members).subspan(begin, std::min(block_size, end - begin));
      gather(block, some, sites, box);
      block.run(static_cast<int>(some.size()), sites);
      each(block, some);
    }
  }
  void add_task(LawBlock& block, std::size_t task, Sites& sites, const Box& box, CompensatedSum* energy) const;
  double add(std::vector<LawBlock>& blocks, Sites& sites, const Box& box, const Instant& instant,
             std::span<const double> parameters, Workers& shared, bool with_energy);
  void make_sloped();
  void add_slopes(LawBlock& block, std::size_t task, const Sites& sites, const Box& box, double difference,
                  SiteSlopes& to) const;
};

void Fields::Kernel::add_task(LawBlock& block, std::size_t task, Sites& sites, const Box& box,
                              CompensatedSum* energy) const {
  Vec3* force = law->has_energy() ? sites.force.data() : sites.nonconservative_force.data();
  if (energy != nullptr) *energy = {};
  run(block, task, sites, box, [&](const LawBlock& made, std::span<const std::uint32_t> some) {
    const double *x = made.output(0), *y = made.output(1), *z = made.output(2);
    for (std::size_t k = 0; k < some.size(); k++) force[some[k]] += vec(x[k], y[k], z[k]);
    for (std::size_t k = 0; energy != nullptr && k < some.size(); k++) energy->add(made.output(3)[k]);
  });
}

double Fields::Kernel::add(std::vector<LawBlock>& blocks, Sites& sites, const Box& box, const Instant& instant,
                           std::span<const double> parameters, Workers& shared, bool with_energy) {
  const std::size_t tasks = (members.size() + task_size - 1) / task_size;
  for (LawBlock& block : blocks) block.set(instant, parameters);
  energies.resize(std::max(energies.size(), tasks));
  const auto add_one = [&](std::size_t task, int worker) {
    add_task(blocks[static_cast<std::size_t>(worker)], task, sites, box, with_energy ? &energies[task] : nullptr);
  };
  if (law->called)
    for (std::size_t task = 0; task < tasks; task++) add_one(task, 0);
  else
    shared.run(tasks, add_one);
  CompensatedSum total;
  for (std::size_t task = 0; with_energy && task < tasks; task++) total.add(energies[task]);
  return total.value();
}

void Fields::Kernel::make_sloped() {
  const std::shared_ptr<const Law> with_slopes = with_velocity_slopes(*law);
  linear = is_linear_in_velocity(*with_slopes);
  for (std::size_t k = 0; k < workers; k++) sloped.emplace_back(*with_slopes, false, names);
}

/// Writes the derivatives of a block's forces by velocity, by differences: the law is called once more for each direction.
void Fields::Kernel::add_slopes(LawBlock& block, std::size_t task, const Sites& sites, const Box& box,
                                double difference, SiteSlopes& to) const {
  run(block, task, sites, box, [&](LawBlock& made, std::span<const std::uint32_t> some) {
    const auto vector = [&](std::size_t first, std::size_t k) {
      return vec(made.output(first)[k], made.output(first + 1)[k], made.output(first + 2)[k]);
    };
    std::array<Vec3, block_size> force;
    for (std::size_t k = 0; k < some.size(); k++) to.force[some[k]] += force[k] = vector(0, k);
    for (std::size_t by = 0; by < 3; by++) {
      double* const column = law->called ? made.velocity[0][by] : nullptr;
      if (column != nullptr) {
        for (std::size_t k = 0; k < some.size(); k++) column[k] += difference;
        made.run(static_cast<int>(some.size()), sites);
        for (std::size_t k = 0; k < some.size(); k++) column[k] = sites.v[some[k]][static_cast<int>(by)];
      }
      for (std::size_t k = 0; k < some.size(); k++)
        to.slope[some[k]][static_cast<int>(by)] +=
            column != nullptr ? (vector(0, k) - force[k]) / difference : vector(3 + 3 * by, k);
    }
  });
}

void Fields::Kernel::make_blocks() {
  for (std::size_t k = 0; k < workers; k++) {
    plain.emplace_back(*law, false, names);
    if (law->has_energy()) energetic.emplace_back(*law, true, names);
  }
}

Fields::Fields(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : kernel_(std::make_unique<Kernel>()) {
  assume(law->kind == LawKind::point);
  kernel_->law = std::move(law);
  kernel_->names.assign(names.begin(), names.end());
  kernel_->workers = static_cast<std::size_t>(workers.count());
  kernel_->make_blocks();
}

Fields::~Fields() = default;
Fields::Fields(const Fields& other) : kernel_(std::make_unique<Kernel>()) {
  kernel_->law = other.kernel_->law;
  kernel_->names = other.kernel_->names;
  kernel_->workers = other.kernel_->workers;
  kernel_->members = other.kernel_->members;
}
Fields::Fields(Fields&&) noexcept = default;
Fields& Fields::operator=(Fields&&) noexcept = default;

void Fields::arrange(std::span<const std::uint32_t> members) {
  kernel_->members.assign(members.begin(), members.end());
}

void Fields::add_forces(Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                        Workers& workers) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  kernel_->add(kernel_->plain, sites, box, instant, parameters, workers, false);
}

double Fields::add_forces_and_energy(Sites& sites, const Box& box, const Instant& instant,
                                     std::span<const double> parameters, Workers& workers) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  const bool has = kernel_->law->has_energy();
  return kernel_->add(has ? kernel_->energetic : kernel_->plain, sites, box, instant, parameters, workers, has);
}

bool Fields::add_slopes(const Sites& sites, const Box& box, const Instant& instant, std::span<const double> parameters,
                        Workers& workers, SiteSlopes& to) {
  Kernel& k = *kernel_;
  if (k.sloped.empty()) k.make_sloped();
  const std::size_t tasks = (k.members.size() + task_size - 1) / task_size;
  const double difference = k.law->called ? velocity_difference(sites) : 0.0;
  for (LawBlock& block : k.sloped) block.set(instant, parameters);
  const auto add_one = [&](std::size_t task, int worker) {
    k.add_slopes(k.sloped[static_cast<std::size_t>(worker)], task, sites, box, difference, to);
  };
  if (k.law->called)
    for (std::size_t task = 0; task < tasks; task++) add_one(task, 0);
  else
    workers.run(tasks, add_one);
  return k.linear;
}

std::optional<BadForce> Fields::find_bad(const Sites& sites, const Box& box, const Instant& instant,
                                         std::span<const double> parameters) {
  if (kernel_->plain.empty()) kernel_->make_blocks();
  LawBlock& block = kernel_->plain.front();
  block.set(instant, parameters);
  std::optional<BadForce> bad;
  for (std::size_t task = 0; task * task_size < kernel_->members.size() && !bad; task++)
    kernel_->run(block, task, sites, box, [&](const LawBlock& made, std::span<const std::uint32_t> some) {
      for (std::size_t k = 0; k < some.size() && !bad; k++)
        if (!finite(vec(made.output(0)[k], made.output(1)[k], made.output(2)[k]))) bad = BadForce{{some[k]}, 1, 0.0};
    });
  return bad;
}

}  // namespace pantin
