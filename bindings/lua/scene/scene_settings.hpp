#pragma once
// The settings of a script; those of the world are in bindings/fields.
#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// Takes a table of what is wished of the camera.
void write_camera(const Self& s, int index);

/// How it is shown and run: title, duration, pace, camera, dark, store, saved, contact_sounds.
std::vector<Field> show_settings();

}  // namespace pantin::lua
