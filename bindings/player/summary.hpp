#pragma once
#include <nlohmann/json.hpp>

#include "lua/scene.hpp"

namespace pantin::player {

/// Where energy came from and went, [J].
nlohmann::ordered_json ledger(const World& world);

/// What a run came to: time, energies, errors, counts, times per phase, results, warnings, hash of the state; and the error
/// that stopped it, if one did.
nlohmann::ordered_json summary(const lua::Scene& scene, const std::string& failure = "");

}  // namespace pantin::player
