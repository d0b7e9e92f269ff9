// A pulley: a rope over two anchors, at most so long; the second side counts `ratio` times, as by a tackle.
#include "constraints/coupling.hpp"
#include "constraints/plans.hpp"

namespace pantin {

const ConstraintRule pulley_rule = {
    .keeps = {"ratio", "", KeptNumber::Range::positive},
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{0, 0};
        },
    .directions = no_direction,
    .start = start_coupling,
    .gap = coupling_gap,
    .size = [](const Constraint& c) { return c.as<CouplingData>().total; },
    .follow = follow_ratio,
    .rows = coupling_rows,
    .has_range = [](const Constraint&) { return true; },
};

}  // namespace pantin
