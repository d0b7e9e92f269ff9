#include "player/message.hpp"

#include <iostream>

#include "scene/errors.hpp"

namespace pantin::player {

void say(const std::string& message) { std::cerr << (names_place(message) ? "" : "pantin: ") << message << std::endl; }

}  // namespace pantin::player
