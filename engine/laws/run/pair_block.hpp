#pragma once
// The pairs of some rows that are near enough, on their way through a law, in one thread.
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "base/aligned.hpp"
#include "laws/run/block.hpp"
#include "laws/run/neighbours.hpp"

namespace pantin {

class PairCode;

struct PairLimits {
  double cutoff2 = 0.0;  ///< [m²] pairs that are not nearer are left out
  double least2 = 0.0;   ///< [m²] those that are nearer are taken to be so far from each other
};

/// A block of pairs: each of a row's site and one neighbour.
struct PairBlock : Block {
  /// What of a row is in the block.
  struct Part {
    std::uint32_t site = 0;
    int count = 0;
    Vec3 from = zero3();  ///< [m] position of the site as its neighbours see it
  };

  AlignedVector<std::uint32_t> neighbours;
  std::array<Part, LawBlock::most> parts;
  int part_count = 0;
  std::shared_ptr<const PairCode> code;  ///< in one pass: reads attributes at the sites

  explicit PairBlock(LawBlock made);

  /// Takes pairs of the task's slab that are within the limits, of a touching law those that touch: `radius` is its column of
  /// radii, or null. Then fills in what the law wants to see.
  void gather(const Sites& sites, const Vec3* shifts, const PairLimits& limits, const double* radius, Task& task);
  /// Fills in what changes when the row's site is b.
  void exchange_roles(const Sites& sites);
  /// Calls each(part, number of its first pair).
  template <class Each>
  void each_part(Each each) const {
    int at = 0;
    for (int p = 0; p < part_count; p++) {
      const Part& part = parts[static_cast<std::size_t>(p)];
      each(part, at);
      at += part.count;
    }
  }

 private:
  void take_near(const Sites& sites, const Vec3* shifts, const PairLimits& limits, Task& task);
  void keep_touching(const double* radius);
  void gather_vectors(const Sites& sites);
  void gather_attributes(const Sites& sites, bool exchanged);
  void gather_sites(bool exchanged);
};

}  // namespace pantin
