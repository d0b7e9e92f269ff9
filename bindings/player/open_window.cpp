#include "player/open_window.hpp"

namespace pantin::player {

Window open_window(const std::string& title, Size size) {
  try {
    return Window(title, size.width, size.height);
  } catch (const Error& error) { throw NoWindow(error.what()); }
}

}  // namespace pantin::player
