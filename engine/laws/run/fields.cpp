#include "laws/run/fields.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace pantin {

namespace {

constexpr std::size_t field_block_size = LawBlock::most, task_size = 4 * field_block_size;

}  // namespace

Fields::Fields(std::shared_ptr<const Law> law, std::span<const std::string> names, const Workers& workers)
    : LawOnSites(std::move(law), names, workers) {
  assume(this->law().kind == LawKind::point);
  make_blocks();
}

void Fields::arrange(std::span<const std::uint32_t> members) { members_.assign(members.begin(), members.end()); }

std::size_t Fields::tasks(std::size_t /*phase*/) const { return (members_.size() + task_size - 1) / task_size; }

Task Fields::task(std::size_t /*phase*/, std::size_t number) const {
  return {.at = number * task_size, .end = std::min((number + 1) * task_size, members_.size())};
}

std::unique_ptr<Block> Fields::make_block(LawBlock made) const { return std::make_unique<Block>(std::move(made)); }

/// Places are seen within the box.
void Fields::gather(Block& block, Task& task, const Sites& sites, const Box& box) const {
  const std::uint32_t* const members = members_.data() + task.at;
  const std::size_t n = std::min(field_block_size, task.end - task.at);
  LawBlock& law = block.law;
  for (std::size_t k = 0; k < n; k++) {
    const Vec3 x = box.wrapped(sites.x[members[k]]), v = sites.v[members[k]];
    for (std::size_t c = 0; c < 3; c++) {
      if (law.position[0][c] != nullptr) law.position[0][c][k] = x[static_cast<int>(c)];
      if (law.velocity[0][c] != nullptr) law.velocity[0][c][k] = v[static_cast<int>(c)];
    }
  }
  law.gather_of({&members, 1}, n, sites);
  block.first = task.at;
  block.count = static_cast<int>(n);
  task.at += n;
}

void Fields::scatter(const Block& block, const Sites& /*sites*/, Vec3* force) {
  const std::uint32_t* const members = members_.data() + block.first;
  const double *x = block.law.output(0), *y = block.law.output(1), *z = block.law.output(2);
  for (std::size_t k = 0; k < static_cast<std::size_t>(block.count); k++) force[members[k]] += vec(x[k], y[k], z[k]);
}

}  // namespace pantin
