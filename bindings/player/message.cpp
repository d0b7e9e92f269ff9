#include "player/message.hpp"

#include <iostream>

#include "lua/error_text.hpp"

namespace pantin::player {

void say(const std::string& message) {
  std::cerr << (lua::names_place(message) ? "" : "pantin: ") << message << std::endl;
}

}  // namespace pantin::player
