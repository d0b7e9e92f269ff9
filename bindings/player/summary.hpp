#pragma once
#include <string>

#include "scene/scene.hpp"

namespace pantin::player {

/// What a run came to, as JSON: time, energies, errors, counts, times per phase, results, warnings, hash of the state; and
/// the error that stopped it, if one did.
std::string summary(const Scene& scene, const std::string& failure = "");

}  // namespace pantin::player
