#pragma once
// How long rows are good.
#include "base/aligned.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Watches how far sites have moved since rows were built.
class Skin {
 public:
  /// Starts to watch; the rows are good while no site has moved more than half of `width` [m].
  void restart(const Sites& sites, double width);
  bool spent(const Sites& sites) const;
  double width() const { return width_; }  ///< [m]

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  AlignedVector<Vec3> start_;
  double width_ = 0.0;
};

/// A skin for which building rows and evaluating them together cost least, if sites go on as they move now. A function
/// of their velocities, dt [s], and cutoff [m]; at most half the cutoff.
double best_skin(const Sites& sites, double dt, double cutoff);

}  // namespace pantin
