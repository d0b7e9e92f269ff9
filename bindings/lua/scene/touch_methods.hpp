#pragma once
// What scenes do with shapes: floors and ground, layers, and what is met by rays and shapes on their way.
#include <vector>

#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// floor, ground, collide
std::vector<Method> touch_methods();
/// ray, cast, overlap, inside
std::vector<Method> hit_methods();

}  // namespace pantin::lua
