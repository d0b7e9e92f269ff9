#pragma once
// Random islands of contacts, and their problem written out: for what judges single solves.
#include <Eigen/Core>
#include <cstdint>
#include <random>

#include "contacts/solve/island.hpp"

namespace pantin::support {

struct Chance {
  std::mt19937_64 engine;
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1.0p-53;
  }
  int below(int count) { return static_cast<int>(engine() % static_cast<std::uint64_t>(count)); }
  Vec3 vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return vec(x, y, z);
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector(1.0);
      if (norm2(v) > 0.01 && norm2(v) < 1.0) return v / norm(v);
    }
  }
};

/// Bodies at random, each held by the world or by one before it, and some more contacts; masses up to `ratio` : 1.
ContactIsland random_island(Chance& chance, double ratio);

/// u = W γ + q of all contacts, each with n, t1, t2.
struct DenseProblem {
  Eigen::MatrixXd W;  ///< [1/kg]
  Eigen::VectorXd q;  ///< [m/s]

  explicit DenseProblem(const ContactIsland& island);
  /// u [m/s] with γ [N s].
  Eigen::VectorXd velocities(const Eigen::VectorXd& impulses) const;
};

}  // namespace pantin::support
