#pragma once
#include "view/camera.hpp"
#include "view/gestures.hpp"
#include "view/views.hpp"

namespace pantin {

/// Toggles views and turns the camera by the keys that were pressed.
void take_view_keys(const Gestures& gestures, Views& views, Camera& camera);

}  // namespace pantin
