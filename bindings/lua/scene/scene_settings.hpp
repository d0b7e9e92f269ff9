#pragma once
// The settings of a script; those of the world are in bindings/fields.
#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// How it is shown and run: title, duration, pace, camera, store.
std::vector<Field> show_settings();

}  // namespace pantin::lua
