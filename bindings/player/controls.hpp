#pragma once
#include "scene/scene.hpp"
#include "view/gestures.hpp"
#include "view/viewport.hpp"

namespace pantin::player {

/// Tells a scene, by commands of its coming step, what of the keys and gamepads that it reads is held now, where that is
/// not what it knows, and takes it out of the gestures, so that it is not for the window. `heard`: else all is let go, as
/// where a text is typed. What is pressed and let go within a step is held for one.
void give_controls(const Scene& scene, bool heard, Gestures& gestures, StepInput& waiting);
/// The same of the mouse, once panels have taken what is theirs. The first finger is the mouse with its left button down.
void give_mouse(const Scene& scene, const Viewport& viewport, bool heard, Gestures& gestures, StepInput& waiting);

}  // namespace pantin::player
