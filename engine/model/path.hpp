#pragma once
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

/// A curve through given positions: straight pieces, or a spline with continuous curvature. Its parameter goes from 0 to
/// the number of pieces, one piece between two positions.
class Path {
 public:
  /// `positions` [m]: two or more, of which no two that follow each other are the same; throws Error where they are not.
  Path(std::vector<Vec3> positions, bool smooth, bool closed);

  Vec3 position(double u) const;
  Vec3 tangent(double u) const;              ///< of unit length
  double extent() const { return extent_; }  ///< [m] of the largest number in its positions
  double pieces() const { return static_cast<double>(pieces_.size()); }
  bool closed() const { return closed_; }
  bool smooth() const { return smooth_; }
  const std::vector<Vec3>& positions() const { return positions_; }
  /// Parameter of the nearest position, near another parameter, and of all.
  double nearest(Vec3 to, double near) const;
  double nearest(Vec3 to) const;

 private:
  struct Piece {
    Vec3 a, b, c, d;  // a + b t + c t² + d t³
  };
  const Piece& piece(double u, double& t) const;
  double step_towards(Vec3 to, double u) const;

  std::vector<Vec3> positions_;
  std::vector<Piece> pieces_;
  bool smooth_, closed_;
  double extent_ = 0.0;
};

}  // namespace pantin
