#pragma once
#include <string>
#include <vector>

#include "peers/trial.hpp"

namespace pantin {

/// Pantin's own ways to move a mechanism: every integrator, without the energy return and with it (" + return").
std::vector<peers::Setting> pantin_settings();

/// A world as a scene has it where it sets nothing, and one that sets `contact` to "fast".
std::vector<peers::Setting> pantin_pile_settings();

}  // namespace pantin
