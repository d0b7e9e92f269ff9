#pragma once

namespace pantin::player {

enum class Icon { scenes, previous, restart, next, pause, play, step, slower, faster, picture, film, end_film, panels };

/// A button with a drawing instead of a text; `about` is shown while the pointer rests on it.
bool icon_button(Icon icon, const char* about);

}  // namespace pantin::player
