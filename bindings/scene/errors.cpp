#include "scene/errors.hpp"

namespace pantin {

bool names_place(const std::string& message) {
  const auto colon = message.find(':');
  if (colon == std::string::npos || colon == 0) return false;
  const auto after = message.find_first_not_of("0123456789", colon + 1);
  return after != std::string::npos && after > colon + 1 && message.compare(after, 2, ": ") == 0;
}

}  // namespace pantin
