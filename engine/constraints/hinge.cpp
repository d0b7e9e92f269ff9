// Hinge, nail, rigid follow, weld and orient: two points, or two orientations, stay together.
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

/// The chord of the rotation, world axes: 2 sin(θ/2) along its axis, whose change is the small rotation itself.
void read_chord(Row& row, Condition& condition, const Orientations& nodes) {
  const Quat violation = nodes.violation(condition.turn1);
  const double sign = violation.w < 0.0 ? -2.0 : 2.0;
  row.d1 = nodes.R * vec(violation.x * sign, violation.y * sign, violation.z * sign) * row.lever;
}

}  // namespace

const RowRule rigid_row = {.forbids_as_newton = true, .offsets_gap = true, .read_turn = read_chord};

}  // namespace pantin
