#pragma once
// The settings of a scene, as Lua reads and writes them.
#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// How it is shown and run: title, duration, pace, camera, store.
std::vector<Field> show_settings();
/// Of the engine: gravity, step, accuracy, integrator, box, plane and more.
std::vector<Field> engine_settings();

}  // namespace pantin::lua
