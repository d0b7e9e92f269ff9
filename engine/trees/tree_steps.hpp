#pragma once
// A tree moved in time: the method of Dormand and Prince of order 8, in steps of the length at which its error is as wanted.
// Who asks may ask for any moment: a step goes past it, and a polynomial of degree 7 tells what is between.
#include "trees/tree.hpp"

namespace pantin {

struct StepControl {
  double error_rate = 0.0;  ///< [m/s] largest local error of a point
  double shortest = 0.0;    ///< [s] a step is not made shorter
  double longest = 0.0;     ///< [s] nor longer
};

/// What moving it took.
struct TreeCost {
  std::uint32_t evaluations = 0, taken = 0, rejected = 0;
  double missed = 0.0;  ///< [m/s] error of steps that could not be shorter, or round-off; 0: none
};

/// Finds the rates at the end of a fresh course.
void begin_course(const Tree& tree, TreeWorkspace& workspace, TreeCourse& course, Vec3 gravity, TreeCost& cost);

/// The longest step that is taken [s]: h rate = 5.5, where the method is stable to 5.9.
double stable_length(double own_rate2);

/// Moves the present of a course that has begun by `time` [s] > 0 under a gravity [m/s²]. False where the state does not stay finite; nothing is then
/// left of the course.
bool advance(const Tree& tree, TreeWorkspace& workspace, TreeCourse& course, double time, Vec3 gravity,
             const StepControl& control, TreeCost& cost);

/// The state at present, of unit length.
void read_present(const TreeCourse& course, TreeState& state);

}  // namespace pantin
