// A rack: a point moves as far as the rim of a wheel turns; the ratio is the radius [m].
#include "constraints/coupling.hpp"
#include "constraints/plans.hpp"

namespace pantin {

const ConstraintRule rack_rule = {
    .keeps = {"radius", "m", KeptNumber::Range::not_zero},
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
          needs.push_back({"along", c.coupled()[1].direction, false});
          return needs;
        },
};

}  // namespace pantin
