#include "base/check.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace pantin {

std::string to_text(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::string rounded(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g", value);
  return buffer;
}

void TextPart::append_to(std::string& text) const {
  const auto whole = [&](auto value) {
    char buffer[24];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  };
  switch (kind_) {
    case Kind::text: text += text_; return;
    case Kind::letter: text += letter_; return;
    case Kind::number: text += to_text(number_); return;
    case Kind::whole: return whole(whole_);
    case Kind::count: return whole(count_);
  }
}

std::string joined_text(std::initializer_list<TextPart> parts) {
  std::string text;
  for (const TextPart& part : parts) part.append_to(text);
  return text;
}

void assumption_failed(const char* condition, const char* file, int line) {
  throw std::logic_error(text("a fault of Pantin itself: ", condition, " does not hold (", file, ":", line, ")"));
}

}  // namespace pantin
