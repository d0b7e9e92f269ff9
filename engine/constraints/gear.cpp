// A gear: one body turns `ratio` times as far as another, each about an axis of a carrier, or of the world.
#include "constraints/coupling.hpp"
#include "constraints/plans.hpp"

namespace pantin {

const ConstraintRule gear_rule = {
    .keeps = {"ratio", "", KeptNumber::Range::not_zero},
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{1, 1};
        },
    .directions = no_direction,
    .start = start_coupling,
    .gap = coupling_gap,
    .follow = follow_ratio,
    .rows = coupling_rows,
    .in_plane = axes_of_coupling,
};

}  // namespace pantin
