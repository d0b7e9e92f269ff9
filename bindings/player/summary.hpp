#pragma once
#include <nlohmann/json.hpp>

#include "lua/scene.hpp"

namespace pantin::player {

/// Where energy came from and went, [J].
nlohmann::ordered_json ledger(const World& world);

/// What a run came to: time, energies, errors, counts, times per phase, results, warnings, hash of the state.
nlohmann::ordered_json summary(const lua::Scene& scene);

}  // namespace pantin::player
