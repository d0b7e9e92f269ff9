#pragma once
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace pantin::player {

/// A sentence where a run's energy is not to be trusted.
std::optional<std::string> energy_gone_wrong(const World& world);

/// A sentence where shapes overlapped by more than is meant: how deep at most, which, and when.
std::optional<std::string> deep_overlap(const World& world);
/// A sentence where impulses of contacts were left that miss the law of friction.
std::optional<std::string> loosely_solved(const World& world);

/// A sentence where contacts gave much energy that was taken back, which no energy error tells.
std::optional<std::string> gains_taken_back(const World& world);

/// A few lines on standard output at the end of a run, and the scene's warnings on standard error. `seconds` of wall time.
void print_closing(const Scene& scene, const std::string& path, double seconds);

}  // namespace pantin::player
