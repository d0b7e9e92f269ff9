#include "player/message.hpp"

#include <iostream>

#include "scene/errors.hpp"
#include "scene/printable.hpp"

namespace pantin::player {

void say(const std::string& message) {
  std::cerr << (names_place(message) ? "" : "pantin: ") << printable(message) << std::endl;
}

}  // namespace pantin::player
