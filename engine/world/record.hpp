#pragma once
// Who acts, and what is told of it.
#include <string>

#include "world/world.hpp"

namespace pantin::internal {

/// Who acts right now: the script's line, a hand, or "the program".
std::string culprit(const World& world);
/// Remembers who acts, for the case that the state goes wrong.
void acted(World& world);
Obituary obituary(const World& world, std::string what);
void notice(World& world, Notice::Kind kind, const AnyId& thing, std::string story, std::int32_t hand = -1);

}  // namespace pantin::internal
