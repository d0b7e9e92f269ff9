#pragma once
// Paths of straight pieces have corners, at which the tangent leaps. Up to a sharp one a point moves as if its piece went on; at
// it the part of the step ends, and the velocities are turned as by a curve that is as small as one likes: by rotations of the
// tangent, at the middle of each of which what is forbidden changes its sign.
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// Whether a point is on a path with sharp corners.
bool has_sharp_corners(const Articulate& articulate);

/// What a part of a step changes, to begin it again.
class PartStart {
 public:
  PartStart(const Articulate& articulate, const DriftReport& report);
  void put_back(Articulate& articulate, DriftReport& report) const;
  /// After a part of h [s] that is too short for forces: closing gaps of round-off takes what they like. Only positions are of it.
  void put_back_forces(Articulate& articulate, DriftReport& report, double h) const;

 private:
  ArticulateState state_;
  std::vector<Node> nodes_;
  std::vector<Vec3> forces_, offsets_;  // (rows) [N], [m]
  DriftReport report_;
};

/// Finds when in a part of a step the first point comes to a corner: the root of how far [m] those that are past one, at its end or
/// where it was tried, are past it; from where a cubic through both ends has it, by Newton's rule within bounds.
class CornerSearch {
 public:
  /// After the part, of h [s].
  CornerSearch(const Articulate& articulate, double h);
  bool none_passed() const { return passed_.empty(); }
  /// At the start of the part.
  void begin(const Articulate& articulate);
  bool done() const { return tries_ > 0 && (std::fabs(last_.past) <= tolerance_ || tries_ >= most_tries); }
  /// Whether it is there from the start on.
  bool at_start() const;
  /// The part of it (0 … 1) to be tried next, and the last one.
  double next();
  double last() const { return last_.part; }
  /// After such a part.
  void tell(const Articulate& articulate);

 private:
  static constexpr int most_tries = 40;
  struct Passed {
    std::size_t condition;
    bool ahead;
  };
  struct Moment {
    double part, past, rate;  // (0 … 1), [m], [m] in all of the part
  };
  void add_passed(const Articulate& articulate);
  Moment farthest(const Articulate& articulate, double part) const;
  double cubic_root() const;

  double h_;
  std::vector<Passed> passed_;
  double tolerance_ = 0.0;  // [m]
  Moment low_{}, high_{}, last_{};
  int tries_ = 0;
};

/// Turns velocities round the corners that points have come to. For the `last` time in a step: what came back to its corner stays
/// there, and the rest is solved on its path as it is.
void turn_at_corners(Articulate& articulate, const DriftSettings& settings, double at, bool last, DriftReport& report);

}  // namespace pantin
