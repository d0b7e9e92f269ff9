// A gear: one body turns `ratio` times as far as another, each about an axis of a carrier, or of the world.
#include "constraints/coupling.hpp"

namespace pantin {

const ConstraintRule gear_rule = coupling_rule({"ratio", "", KeptNumber::Range::not_zero}, axes_of_coupling);

}  // namespace pantin
