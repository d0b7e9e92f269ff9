#include "laws/run/neighbours.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "base/check.hpp"
#include "laws/run/cells.hpp"
#include "laws/run/scanner.hpp"

namespace pantin {

namespace {

constexpr std::size_t least_sites_of_a_slab = 256;

[[noreturn, gnu::cold]] void refuse_pairs(std::size_t count, double cutoff) {
  refuse(count, " particles have more than ", NeighbourList::most_pairs, " pairs nearer than the cutoff of ", cutoff,
         " m: a shorter cutoff or fewer particles near each other are needed");
}

}  // namespace

/// What a build needs, kept for the next one.
struct NeighbourList::Work {
  std::vector<std::uint32_t> a, b;  ///< members
  Grid grid;
  Cells cells_a, cells_b;
  std::vector<std::size_t> slab_begin;  ///< lines
  std::vector<Slab> slabs;
  std::vector<std::uint32_t> tiled;  ///< members in tiles, each filled up with the dummy
  std::atomic<std::uint64_t> pairs{0};
};

namespace {

/// Cuts lines into slabs so thick that what a slab reaches is in itself and its neighbours: first lines, and an end.
/// Every other slab then meets none of the others, in a box because their number is even.
void cut_slabs(const Grid& grid, const Cells& cells, bool within, std::vector<std::size_t>& begin) {
  const std::int32_t thick = within ? Grid::around : 2 * Grid::around;
  const std::size_t end = cells.lines.size() - 1;
  begin.assign(1, 0);
  const auto site = [&](std::size_t line) { return cells.cells[cells.lines[line].begin].begin; };
  const auto layer = [&](std::size_t line) { return cells.lines[line].layer; };
  // As many in both phases, and in each a number that two or four threads share out evenly.
  const auto wanted =
      std::min(static_cast<std::size_t>(grid.cells[Grid::of_layer] / thick), cells.n / least_sites_of_a_slab);
  const std::size_t count = std::max<std::size_t>(1, wanted < 8 ? wanted : wanted / 8 * 8);
  for (std::size_t line = 1; line < end; line++) {
    const bool new_layer = layer(line) != layer(line - 1);
    if (new_layer && layer(line) - layer(begin.back()) >= thick && site(line) >= begin.size() * cells.n / count)
      begin.push_back(line);
  }
  const auto to_the_first = [&] { return layer(0) + grid.cells[Grid::of_layer] - layer(begin.back()); };
  if (grid.periodic && begin.size() > 1 && to_the_first() < thick) begin.pop_back();
  if (grid.periodic && begin.size() % 2 == 1 && begin.size() > 1) begin.pop_back();
  begin.push_back(end);
}

/// All pairs, in square pieces of their table: rows of a tile of a, neighbours of a tile of b.
class Tiles {
 public:
  Tiles(const Omitted& omitted, const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b, bool within,
        bool listed)
      : omitted_(omitted), a_(a), b_(b), within_(within), listed_(listed) {
    count_ = std::max(a.size(), b.size()) < 512 ? 1 : 16;
    stride_ = (b.size() / count_ + 1 + 3) / 4 * 4 + 4;
  }

  std::size_t count() const { return count_; }
  std::size_t pairs() const { return pairs_; }

  /// Writes the list that the rows of all slabs share; must outlive them.
  void fill(std::vector<std::uint32_t>& tiled) {
    tiled.assign(count_ * stride_, omitted_.sites.dummy());
    for (std::size_t tile = 0; tile < count_; tile++)
      std::copy(b_.begin() + at(b_, tile), b_.begin() + at(b_, tile + 1),
                tiled.begin() + static_cast<std::ptrdiff_t>(tile * stride_));
    tiled_ = tiled.data();
  }

  Slab slab(std::size_t i, std::size_t j) {
    Slab slab;
    if (!listed_) slab.list = tiled_;
    const auto length = static_cast<std::size_t>(at(b_, j + 1) - at(b_, j));
    for (std::ptrdiff_t k = at(a_, i); k < at(a_, i + 1); k++) {
      const std::size_t from = within_ && i == j ? static_cast<std::size_t>(k - at(a_, i)) + 1 : 0;
      add_row(slab, a_[static_cast<std::size_t>(k)], j * stride_ + from, length - from);
    }
    return slab;
  }

 private:
  std::ptrdiff_t at(const std::vector<std::uint32_t>& members, std::size_t tile) const {
    return static_cast<std::ptrdiff_t>(members.size() * tile / count_);
  }
  void add_row(Slab& slab, std::uint32_t site, std::size_t begin, std::size_t count) {
    constexpr std::uint32_t unshifted = 13;
    if (listed_) {
      const std::size_t first = slab.own.size();
      slab.own.resize(first + count);
      std::copy_n(tiled_ + begin, count, slab.own.begin() + first);
      count = static_cast<std::size_t>(omitted_.remove(site, slab.own.begin() + first, slab.own.end()) -
                                       (slab.own.begin() + first));
      slab.own.resize(first + count);
      if (count > 0) close_row(slab, site, first, count, unshifted, omitted_.sites.dummy());
    } else if (count > 0) {
      slab.rows.push_back(
          {site, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>((count + 3) / 4 * 4), unshifted});
    }
    pairs_ += count;
  }

  Omitted omitted_;
  const std::vector<std::uint32_t>&a_, &b_;
  bool within_, listed_;
  std::size_t count_ = 1, stride_ = 4, pairs_ = 0;
  const std::uint32_t* tiled_ = nullptr;
};

}  // namespace

NeighbourList::NeighbourList() : work_(std::make_unique<Work>()) {}
NeighbourList::~NeighbourList() = default;
NeighbourList::NeighbourList(const NeighbourList& other)
    : phases_(other.phases_),
      work_(std::make_unique<Work>()),
      pairs_(other.pairs_),
      slots_(other.slots_),
      within_(other.within_),
      cutoff_(other.cutoff_),
      reach_(other.reach_),
      least_distance2_(other.least_distance2_) {
  std::copy(std::begin(other.shifts_), std::end(other.shifts_), std::begin(shifts_));
  work_->tiled = other.work_->tiled;
  const std::uint32_t* shared = other.work_->tiled.data();
  for (std::size_t phase = 0; phase < phases_.size(); phase++)
    for (std::size_t k = 0; k < phases_[phase].size(); k++) {
      Slab& slab = phases_[phase][k];
      const bool of_all = !work_->tiled.empty() && other.phases_[phase][k].list == shared;
      slab.list = of_all ? work_->tiled.data() : slab.own.data();
    }
}
NeighbourList::NeighbourList(NeighbourList&&) noexcept = default;

const std::vector<std::uint32_t>& NeighbourList::tiled() const { return work_->tiled; }

void NeighbourList::set_lists(const std::vector<std::uint32_t>& tiled, const std::vector<std::vector<char>>& of_all) {
  work_->tiled = tiled;
  for (std::size_t phase = 0; phase < phases_.size(); phase++)
    for (std::size_t k = 0; k < phases_[phase].size(); k++) {
      Slab& slab = phases_[phase][k];
      slab.list = of_all[phase][k] != 0 ? work_->tiled.data() : slab.own.data();
    }
}

NeighbourList& NeighbourList::operator=(NeighbourList&&) noexcept = default;

void NeighbourList::build(const Sites& sites, const Box& box, std::span<const std::uint32_t> a,
                          std::span<const std::uint32_t> b, double cutoff, double skin, Workers& workers,
                          const Exclusions& further) {
  const double half = 0.5 * std::min({box.edge[0], box.edge[1], box.edge[2]});
  require(!box.periodic() || cutoff < infinity, "in a periodic box a law needs a cutoff, of at most half an edge, ",
          half, " m");
  require(!box.periodic() || cutoff <= half, "the cutoff of ", cutoff, " m is longer than half of the periodic box, ",
          half, " m");
  const Omitted omitted{sites, further};
  within_ = std::equal(a.begin(), a.end(), b.begin(), b.end());
  cutoff_ = cutoff;
  reach_ = cutoff + skin;
  pairs_ = slots_ = 0;
  work_->slabs.clear();
  for (std::vector<Slab>& phase : phases_)
    for (Slab& slab : phase) work_->slabs.push_back(std::move(slab));
  phases_.clear();
  work_->a.clear();
  work_->b.clear();
  for (std::uint32_t i = 0; i < sites.n; i++) {
    if (std::find(a.begin(), a.end(), sites.family[i]) != a.end()) work_->a.push_back(i);
    if (!within_ && std::find(b.begin(), b.end(), sites.family[i]) != b.end()) work_->b.push_back(i);
  }
  for (int k = 0; k < 27; k++) {
    const int row = k / 3 % 3, layer = k / 9;
    shifts_[k] = box.edge * vec(k % 3 - 1, row - 1, layer - 1);
  }
  const double finite_reach = cutoff < infinity ? reach_ : 1.0;
  work_->grid = make_grid({sites.x.data(), sites.n}, work_->a, work_->b, box, finite_reach);
  const double scale = cutoff < infinity ? cutoff : work_->grid.extent > 0.0 ? work_->grid.extent : 1.0;
  least_distance2_ = 1e-24 * scale * scale;
  if (work_->a.empty() || (!within_ && work_->b.empty())) return;
  if (cutoff < infinity)
    build_by_cells(omitted, workers);
  else
    build_all(omitted);
  for (std::vector<Slab>& phase : phases_)
    for (Slab& slab : phase) {
      if (slab.list == nullptr) slab.list = slab.own.data();
      for (const NeighbourRow& row : slab.rows) slots_ += row.count;
    }
}

void NeighbourList::build_by_cells(const Omitted& omitted, Workers& workers) {
  const Sites& sites = omitted.sites;
  Work& work = *work_;
  const std::span<const Vec3> positions(sites.x.data(), sites.n);
  work.cells_a.fill(work.grid, positions, work.a);
  if (!within_) work.cells_b.fill(work.grid, positions, work.b);
  const Cells &a = work.cells_a, &b = within_ ? a : work.cells_b;
  std::uint64_t least = 0;  // pairs that share a cell
  for (std::size_t c = 0; within_ && work.grid.narrow && c + 1 < a.cells.size(); c++) {
    const std::uint64_t n = a.cells[c + 1].begin - a.cells[c].begin;
    least += n * (n - 1) / 2;
  }
  if (least > most_pairs) refuse_pairs(a.n, cutoff_);
  cut_slabs(work.grid, a, within_, work.slab_begin);
  const std::size_t count = work.slab_begin.size() - 1;
  work.slabs.resize(std::max(count, work.slabs.size()));
  work.pairs = 0;
  workers.run(count, [&](std::size_t k, int) {
    Slab& slab = work.slabs[k];
    slab.rows.clear();
    slab.own.resize(0);
    slab.list = nullptr;
    Scanner scanner(omitted, work.grid, a, b, within_, reach_, shifts_);
    for (std::size_t line = work.slab_begin[k]; line < work.slab_begin[k + 1]; line++)
      if ((work.pairs += scanner.add_line(slab, line)) > most_pairs) refuse_pairs(a.n + b.n, cutoff_);
  });
  pairs_ = work.pairs;
  phases_.resize(count > 1 ? 2 : 1);
  for (std::size_t k = 0; k < count; k++) phases_[k % 2].push_back(std::move(work.slabs[k]));
}

void NeighbourList::build_all(const Omitted& omitted) {
  Work& work = *work_;
  const std::vector<std::uint32_t>&a = work.a, &b = within_ ? work.a : work.b;
  const auto excludes = [&](std::uint32_t i) { return omitted.has(i); };
  const bool listed = std::any_of(a.begin(), a.end(), excludes);
  const std::uint64_t most = listed ? most_pairs : most_pairs_uncut;
  const std::uint64_t count = within_ ? a.size() * (a.size() - 1) / 2 : a.size() * b.size();
  require(count <= most, a.size() + (within_ ? 0 : b.size()), " particles have ", count, " pairs, more than the ", most,
          " that a law without a cutoff may have: give it a cutoff");
  Tiles tiles(omitted, a, b, within_, listed);
  tiles.fill(work.tiled);
  const std::size_t n = tiles.count();
  if (within_) {
    phases_.emplace_back();
    for (std::size_t i = 0; i < n; i++) phases_.back().push_back(tiles.slab(i, i));
  }
  // Each tile meets each other one: in turn, or as in a tournament where everybody plays in every round.
  for (std::size_t round = 0; round + 1 < n || (!within_ && round < n); round++) {
    phases_.emplace_back();
    if (!within_)
      for (std::size_t i = 0; i < n; i++) phases_.back().push_back(tiles.slab(i, (i + round) % n));
    else
      for (std::size_t k = 0; k < n / 2; k++) {
        const std::size_t i = (round + k) % (n - 1), j = k == 0 ? n - 1 : (round + n - 1 - k) % (n - 1);
        phases_.back().push_back(tiles.slab(std::min(i, j), std::max(i, j)));
      }
  }
  pairs_ = tiles.pairs();
}

std::size_t NeighbourList::memory() const {
  std::size_t bytes = work_->tiled.capacity() * sizeof(std::uint32_t);
  for (const std::vector<Slab>& phase : phases_)
    for (const Slab& slab : phase)
      bytes += slab.rows.capacity() * sizeof(NeighbourRow) + slab.own.capacity() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace pantin
