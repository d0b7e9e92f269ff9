#include "base/check.hpp"

#include <charconv>
#include <cmath>

namespace pantin {

std::string to_text(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

void assumption_failed(const char* condition, const char* file, int line) {
  throw std::logic_error(text("a fault of Pantin itself: ", condition, " does not hold (", file, ":", line, ")"));
}

}  // namespace pantin
