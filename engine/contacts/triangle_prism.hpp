#pragma once
#include "shapes/hull.hpp"

namespace pantin {

/// A triangle with solid behind it, as a hull: its corners are vertices 0, 1, 2, its front is face 0. Set anew for each
/// triangle it asks for no memory.
class TrianglePrism {
 public:
  TrianglePrism();
  /// Corners anticlockwise about `normal`, and as deep behind them as told [m].
  void set(const std::array<Vec3, 3>& corner, Vec3 normal, double depth);
  const Geometry& geometry() const { return geometry_; }
  const Hull& hull() const { return *hull_; }

 private:
  std::shared_ptr<Hull> hull_;
  Geometry geometry_;
};

}  // namespace pantin
