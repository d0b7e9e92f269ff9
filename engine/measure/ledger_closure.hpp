#pragma once
// How well the ledger closes.
#include <map>
#include <string>

#include "world/world.hpp"

namespace pantin {

/// |change of the kinetic energy - posts|, since the ledger is kept, over the sum of |posts|, or over the largest kinetic or
/// the potential energy where that is more, as of what rests: a test of the code.
double closure(const World& world);
/// What the energy of a law (and of "gravity") changed by, and what its kicks gave: the step's own error, per law, [J]. Of
/// laws without energy, together: what their kicks gave beyond a second estimate of their work.
std::map<std::string, double> truncation(const World& world);

}  // namespace pantin
