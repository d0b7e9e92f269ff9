#include "player/message.hpp"

#include <cctype>
#include <iostream>

namespace pantin::player {

bool names_line(const std::string& message) {
  auto colon = message.find(':');
  if (colon == std::string::npos || colon == 0) return false;
  auto after = message.find_first_not_of("0123456789", colon + 1);
  return after != std::string::npos && after > colon + 1 && message.compare(after, 2, ": ") == 0;
}

void say(const std::string& message) { std::cerr << (names_line(message) ? "" : "pantin: ") << message << std::endl; }

}  // namespace pantin::player
