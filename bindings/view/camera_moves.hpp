#pragma once
#include "view/gestures.hpp"
#include "view/viewport.hpp"

namespace pantin {

/// Right turns the camera, middle or shift-right shifts it, the wheel zooms, but for one over a panel.
void move_camera(const Gestures& gestures, const PointerEvent& event, bool on_panel, int width, int height,
                 Camera& camera);

/// Puts what plays into a picture of that aspect (width/height): all but what is ten sizes of the stage away, if that is not
/// all there is. Where the camera sees just that already, the whole scene.
void see_all(const World& world, const Stage& stage, double aspect, Camera& camera);

}  // namespace pantin
