// A rack: a point moves as far as the rim of a wheel turns; the ratio is the radius [m].
#include "constraints/coupling.hpp"
#include "constraints/geometry.hpp"

namespace pantin {

namespace {

std::vector<PlaneNeed> in_plane(const Model& model, const Constraint& c) {
  std::vector<PlaneNeed> needs = axes_of_coupling(model, c);
  needs.push_back({"along", direction_of(model, c.coupled()[1].body_b, c.coupled()[1].axis_b), false});
  return needs;
}

}  // namespace

const ConstraintRule rack_rule = coupling_rule({"radius", "m", KeptNumber::Range::not_zero}, in_plane);

}  // namespace pantin
