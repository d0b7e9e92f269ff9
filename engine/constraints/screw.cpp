// A screw: two points move apart by the lead [m] for each turn of one body against another.
#include "constraints/coupling.hpp"

namespace pantin {

namespace {

/// Its points would leave the plane.
std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  std::vector<PlaneNeed> needs = axes_of_coupling(model, c);
  needs.push_back({"the way of a screw, its axis,", needs.front().vector, false});
  return needs;
}

}  // namespace

const ConstraintRule screw_rule = coupling_rule({"lead", "m", KeptNumber::Range::not_zero}, in_plane);

}  // namespace pantin
