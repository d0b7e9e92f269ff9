#include "player/message.hpp"

#include <iostream>

#include "base/check.hpp"
#include "scene/errors.hpp"
#include "scene/printable.hpp"

namespace pantin::player {

void say(const std::string& message) {
  std::cerr << (names_place(message) ? "" : "pantin: ") << printable(message) << std::endl;
}

std::string amount(std::size_t count, const char* one, const char* many) {
  return text(count, ' ', count == 1 ? one : many);
}

}  // namespace pantin::player
