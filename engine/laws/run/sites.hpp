#pragma once
// The particles that laws act on, as the hot loops read them: arrays in an order near to that of the cells of space, so
// that neighbours are near in memory.
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/aligned.hpp"
#include "base/lanes.hpp"

namespace pantin {

/// Where sites live: open space, or a box that repeats along all three axes, with the origin at its corner.
struct Box {
  Vec3 edge = zero3();  ///< [m], all > 0, or all 0 in open space
  bool periodic() const { return edge[0] > 0.0; }
  /// The position in the box, 0 <= x < edge, that x stands for; x itself in open space.
  Vec3 wrapped(Vec3 x) const;
  /// The shortest of the vectors that a difference of two positions in the box stands for.
  Vec3 nearest(Vec3 d) const;
};

/// Pairs of sites that never interact, each listed for both: those of site i are list[begin[i] … begin[i + 1]). No begins:
/// none.
struct Exclusions {
  std::vector<std::uint32_t> begin, list;

  std::span<const std::uint32_t> of(std::uint32_t i) const {
    if (begin.empty()) return {};
    return std::span(list).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// The bodies, by numbers that are not 0, that a site is of: one, or as a hinge several. Those of a hinge are
/// Sites::bodies_of_hinges[begin … begin + count).
struct Kin {
  std::uint32_t first = 0;  ///< 0: of none
  std::uint32_t begin = 0, count = 0;
};

/// Every array holds `n` values and `padding` more. The first of those is the dummy, a site so far away that it is
/// beyond every cutoff, and of no consequence without one; rows are filled up with it.
struct Sites {
  static constexpr std::size_t padding = 16;

  std::size_t n = 0;
  AlignedVector<Vec3> x;      ///< [m]; in a box wrapped when rows are built, and let out of it until the next time
  AlignedVector<Vec3> v;      ///< [m/s]
  AlignedVector<Vec3> force;  ///< [N] of laws with energy
  AlignedVector<Vec3> nonconservative_force;      ///< [N] of laws without
  std::vector<std::uint32_t> particle;            ///< slot in Model::particles
  std::vector<std::uint64_t> serial;              ///< of the particle
  std::vector<std::uint32_t> family;              ///< index
  std::vector<Kin> kin;                           ///< sites that have a body in common never interact
  std::vector<std::uint32_t> bodies_of_hinges;    ///< in no order; some may be of hinges that were
  std::vector<std::string> names;                 ///< of the attributes
  std::vector<AlignedVector<double>> attributes;  ///< one column for each name; a site that has it not holds NaN

  /// Makes room for n sites and puts the dummy in its place; of the columns only the padding is set.
  void resize(std::size_t count);
  void clear_forces();
  std::uint32_t dummy() const { return static_cast<std::uint32_t>(n); }
  std::span<const std::uint32_t> bodies_of(std::uint32_t i) const;
  bool are_kin(std::uint32_t i, std::uint32_t j) const;
};

inline std::span<const std::uint32_t> Sites::bodies_of(std::uint32_t i) const {
  const Kin& k = kin[i];
  if (k.count > 0) return std::span(bodies_of_hinges).subspan(k.begin, k.count);
  return {&k.first, k.first == 0 ? std::size_t{0} : 1};
}

inline bool Sites::are_kin(std::uint32_t i, std::uint32_t j) const {
  if (kin[i].count == 0 && kin[j].count == 0) return kin[i].first != 0 && kin[i].first == kin[j].first;
  for (std::uint32_t body : bodies_of(i))
    for (std::uint32_t other : bodies_of(j))
      if (body == other) return true;
  return false;
}

inline Vec3 Box::wrapped(Vec3 x) const {
  if (!periodic()) return x;
  for (int k = 0; k < 3; k++) {
    const double y = x[k] - edge[k] * std::floor(x[k] / edge[k]);
    x[k] = y < edge[k] ? y : 0.0;
  }
  return x;
}

inline Vec3 Box::nearest(Vec3 d) const {
  if (!periodic()) return d;
  for (int k = 0; k < 3; k++) d[k] -= edge[k] * std::nearbyint(d[k] / edge[k]);
  return d;
}

/// What is the same for all of one evaluation of laws.
struct Instant {
  double time = 0.0;         ///< [s]
  std::uint64_t number = 0;  ///< of the evaluation, for noise
  std::uint64_t seed = 0;    ///< for noise
  bool silent = false;       ///< noise is 0
};

}  // namespace pantin
