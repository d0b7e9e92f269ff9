// A screw: two points move apart by the lead [m] for each turn of one body against another.
#include "constraints/coupling.hpp"
#include "constraints/plans.hpp"

namespace pantin {

const ConstraintRule screw_rule = {
    .keeps = {"lead", "m", KeptNumber::Range::not_zero},
    .freedoms =
        [](const Constraint&) {
          return FreedomsTaken{1, 1};
        },
    .directions = no_direction,
    .start = start_coupling,
    .gap = coupling_gap,
    .follow = follow_ratio,
    .rows = coupling_rows,
    .in_plane =
        [](const Model& model, const Constraint& c) {
          std::vector<PlaneNeed> needs = axes_of_coupling(model, c);
          needs.push_back({"the way of a screw, its axis,", needs.front().vector, false});
          return needs;
        },
};

}  // namespace pantin
