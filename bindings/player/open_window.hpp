#pragma once
#include <string>

#include "base/check.hpp"
#include "player/options.hpp"
#include "view/window.hpp"

namespace pantin::player {

/// There is a screen, but no window with OpenGL can be opened on it.
struct NoWindow : Error {
  using Error::Error;
};

/// Throws NoWindow.
Window open_window(const std::string& title, Size size);

}  // namespace pantin::player
