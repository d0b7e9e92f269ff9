#pragma once
// From a block of pairs that a law of velocity was run over to what an implicit kick reads. For laws/ alone.
#include <utility>
#include <vector>

#include "laws/run/answers.hpp"
#include "laws/run/block.hpp"

namespace pantin {

class PairSlopes {
 public:
  PairSlopes(const Law& law, const Sites& sites, std::vector<VelocityPair>& to)
      : law_(law), sites_(sites), to_(to), difference_(law.called ? velocity_difference(sites) : 0.0) {}

  /// Appends the n pairs of a block that was run, with `d` [m] and `u` [m/s] times `sign` from a to b, and `ends(k)` the
  /// sites of a and b. A called law is run again for its differences.
  template <class Ends>
  void take(LawBlock& block, std::size_t n, const Vec3* d, const Vec3* u, Ends ends, double sign = 1.0) {
    const std::size_t first = to_.size();
    for (std::size_t k = 0; k < n; k++) {
      const auto [a, b] = ends(k);
      VelocityPair pair;
      pair.a = a;
      pair.b = b;
      pair.one_sided = law_.one_sided;
      pair.workless = law_.workless;
      pair.force = force(block, k, d[k] * sign);
      pair.at = u[k] * sign;
      to_.push_back(pair);
    }
    if (law_.called)
      by_differences(block, n, first, d, sign);
    else
      for (std::size_t k = 0; k < n; k++) to_[first + k].slope = slope(block, k, d[k]);
  }

 private:
  bool central() const { return law_.kind == LawKind::central; }
  Vec3 force(const LawBlock& block, std::size_t k, Vec3 d) const {
    if (central()) return d * block.output(0)[k];
    return vec(block.output(0)[k], block.output(1)[k], block.output(2)[k]);
  }
  Mat3 slope(const LawBlock& block, std::size_t k, Vec3 d) const {
    if (central()) return outer(d, d) * block.output(1)[k];
    Mat3 m;
    for (std::size_t by = 0; by < 3; by++)
      m[static_cast<int>(by)] =
          vec(block.output(3 + 3 * by)[k], block.output(4 + 3 * by)[k], block.output(5 + 3 * by)[k]);
    return m;
  }
  void by_differences(LawBlock& block, std::size_t n, std::size_t first, const Vec3* d, double sign) {
    for (std::size_t by = 0; by < (central() ? 1 : 3); by++) {
      double* const column = central() ? block.approach : block.relative_velocity[by];
      if (column == nullptr) continue;
      const std::vector<double> before(column, column + n);
      for (std::size_t k = 0; k < n; k++) column[k] += central() ? difference_ * norm(d[k]) : difference_;
      block.run(static_cast<int>(n), sites_);
      for (std::size_t k = 0; k < n; k++) {
        VelocityPair& pair = to_[first + k];
        const Vec3 change = (force(block, k, d[k] * sign) - pair.force) / difference_;
        if (central())
          pair.slope = outer(change, direction(d[k] * sign));
        else
          pair.slope[static_cast<int>(by)] = change;
        column[k] = before[k];
      }
    }
  }

  const Law& law_;
  const Sites& sites_;
  std::vector<VelocityPair>& to_;
  double difference_;
};

}  // namespace pantin
