#pragma once
#include <string>
#include <vector>

#include "peers/trial.hpp"

namespace pantin {

/// Pantin's own ways to move a mechanism: every integrator, without the energy return and with it (" + return").
std::vector<peers::Setting> pantin_settings();

}  // namespace pantin
