#pragma once
#include <string>
#include <utility>
#include <vector>

#include "view/camera.hpp"
#include "view/gestures.hpp"
#include "view/views.hpp"

namespace pantin {

/// Toggles views and turns the camera by the keys that were pressed.
void take_view_keys(const Gestures& gestures, Views& views, Camera& camera);

/// The same keys, {key, what it does}, for a card of keys that has no others.
const std::vector<std::pair<std::string, std::string>>& view_key_help();

}  // namespace pantin
