#pragma once
#include <vector>

#include "measure/measure.hpp"
#include "world/world.hpp"

namespace pantin {

/// Each thing with all that is joined to it, of which nothing is within `distance` [m] of a place and nothing ties it to the
/// world: what fell out of a scene. The first so many; of scenes with more than 200 free particles those with a body alone.
std::vector<Things> fallen_out(const World& world, Vec3 middle, double distance, std::size_t most);

/// Puts the thing that is meant, with all that is joined to it, at rest, the middle of its box at the command's position; its
/// shape stays. Throws Error where it is gone or a number is not finite.
void bring_back(World& world, const Command& command);

}  // namespace pantin
