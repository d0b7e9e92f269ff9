#pragma once
#include <vector>

#include "base/lanes.hpp"

namespace pantin {

inline constexpr double at_corner = 1e-9;  ///< of a piece: so near a parameter is at a corner

/// Parameters between two sharp corners of a path, from which on a piece goes straight on; where both are one, that corner.
struct PathRun {
  double from = -infinity, to = infinity;
  bool is_corner() const { return from == to; }
  /// Whether it has an end, and a parameter is not beyond one.
  bool has(double u) const {
    return (from > -infinity || to < infinity) && from < to && u > from - at_corner && u < to + at_corner;
  }
};

/// A curve through given positions: straight pieces, or a spline with continuous curvature. Its parameter goes from 0 to
/// the number of pieces, one piece between two positions.
class Path {
 public:
  /// `positions` [m]: two or more, of which no two that follow each other are the same; throws Error where they are not.
  Path(std::vector<Vec3> positions, bool smooth, bool closed);

  Vec3 position(double u, PathRun run = {}) const;
  Vec3 tangent(double u, PathRun run = {}) const;           ///< of unit length
  bool is_straight(double u, double v, PathRun run) const;  ///< both are on one straight piece
  double extent() const { return extent_; }                 ///< [m] of the largest number in its positions
  double pieces() const { return static_cast<double>(pieces_.size()); }
  bool closed() const { return closed_; }
  bool smooth() const { return smooth_; }
  const std::vector<Vec3>& positions() const { return positions_; }
  /// The run that a parameter is in; right at a sharp corner the one that a velocity is along.
  PathRun run(double u, Vec3 velocity) const;
  /// The run that follows at an end of another.
  PathRun next_run(PathRun run, bool ahead) const { return run_of(ahead ? run.to + 0.5 : run.from - 0.5); }
  /// Parameter of the nearest position, near another parameter, and of all.
  double nearest(Vec3 to, double near, PathRun run = {}) const;
  double nearest(Vec3 to) const;

 private:
  struct Piece {
    Vec3 a, b, c, d;  // a + b t + c t² + d t³
  };
  const Piece& piece(double u, double& t, PathRun run = {}) const;
  const Piece& piece_from(double first) const;
  double step_towards(Vec3 to, double u, PathRun run) const;
  bool may_turn_at(double corner) const { return closed_ || (corner > 0.0 && corner < pieces()); }
  PathRun run_of(double u) const;

  std::vector<Vec3> positions_;
  std::vector<Piece> pieces_;
  std::vector<double> sharp_;  // parameters of sharp corners, rising
  bool smooth_, closed_;
  double extent_ = 0.0;
};

}  // namespace pantin
