#pragma once

struct SDL_Window;

namespace pantin {

/// Where the window is on an X display: from now on `lost` becomes true when that goes away, instead of the program
/// ending there and then. `lost` must live as long as the window.
void note_display_loss(SDL_Window* window, bool& lost);

}  // namespace pantin
