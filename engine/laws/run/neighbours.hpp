#pragma once
// Which sites are near enough to interact: neighbour rows (Verlet 1967), found by cells and kept until something has
// moved too far.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/aligned.hpp"
#include "base/parallel.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Neighbours of one site, all seen at the same periodic shift.
struct NeighbourRow {
  std::uint32_t site = 0;
  std::uint32_t begin = 0;  ///< in the list of its slab
  std::uint32_t count = 0;  ///< a multiple of 4; filled up with the dummy
  std::uint32_t shift = 0;  ///< index into NeighbourList::shifts
};

/// NeighbourList that one task goes through, in their order.
struct Slab {
  std::vector<NeighbourRow> rows;
  AlignedVector<std::uint32_t> own;     ///< neighbours
  const std::uint32_t* list = nullptr;  ///< `own`, or the members themselves where all pairs are meant
};

struct Omitted;

/// All pairs of two sets of families nearer than cutoff + skin, each once.
class NeighbourList {
 public:
  /// More pairs than this (2 GiB of memory) are refused.
  static constexpr std::uint64_t most_pairs = std::uint64_t{1} << 29;
  /// As many pairs may be evaluated without a cutoff, where they take no memory.
  static constexpr std::uint64_t most_pairs_uncut = std::uint64_t{1} << 34;

  NeighbourList();
  ~NeighbourList();
  NeighbourList(const NeighbourList&);
  NeighbourList(NeighbourList&&) noexcept;
  NeighbourList& operator=(NeighbourList&&) noexcept;

  /// Pairs within one set (a and b equal) or between two without a common family; with the sets in their order a row's
  /// site is of a. In a box the positions must be wrapped. Throws Error where a position is not finite, the cutoff is longer
  /// than half the box, or the pairs are too many. Pairs of `further` are left out as those of kin are.
  void build(const Sites& sites, const Box& box, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
             double cutoff, double skin, Workers& workers, const Exclusions& further = {});

  /// Slabs of one phase touch no site in common; the phases follow each other.
  const std::vector<std::vector<Slab>>& phases() const { return phases_; }
  std::size_t pairs() const { return pairs_; }  ///< without the dummies
  std::size_t slots() const { return slots_; }  ///< with them
  bool within() const { return within_; }       ///< one set: each pair in the row of either
  double cutoff() const { return cutoff_; }     ///< [m]
  /// Pairs nearer than this are taken to be so far from each other [m²]: 1e-24 times the cutoff's square, or without a
  /// cutoff that of the greatest extent when the rows were built.
  double least_distance2() const { return least_distance2_; }
  const Vec3* shifts() const { return shifts_; }  ///< (27) [m] to be added to a neighbour's position
  std::size_t memory() const;                     ///< [bytes]

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  struct Work;
  void build_by_cells(const Omitted& omitted, Workers& workers);
  void build_all(const Omitted& omitted);
  /// The members in the order in which all pairs are meant, which some slabs list; empty where each lists its own.
  const std::vector<std::uint32_t>& tiled() const;
  /// `of_all`: (phases, slabs) whether it lists those.
  void set_lists(const std::vector<std::uint32_t>& tiled, const std::vector<std::vector<char>>& of_all);

  std::vector<std::vector<Slab>> phases_;
  std::unique_ptr<Work> work_;
  std::size_t pairs_ = 0, slots_ = 0;
  bool within_ = true;
  double cutoff_ = 0.0, reach_ = 0.0, least_distance2_ = 0.0;
  Vec3 shifts_[27] = {};
};

}  // namespace pantin
