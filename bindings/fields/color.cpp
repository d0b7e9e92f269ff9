#include "fields/color.hpp"

#include <cmath>
#include <cstdio>

namespace pantin::fields {

std::string text_of(const Color& color) {
  const float parts[] = {color.r, color.g, color.b, color.a};
  int byte[4];
  for (int i = 0; i < 4; i++)
    byte[i] = static_cast<int>(std::lround(std::fmin(std::fmax(parts[i], 0.0f), 1.0f) * 255.0f));
  char buffer[16];
  if (byte[3] == 255)
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", byte[0], byte[1], byte[2]);
  else
    std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x%02x", byte[0], byte[1], byte[2], byte[3]);
  return buffer;
}

std::optional<Color> color_of_text(std::string_view s) {
  if (s.empty() || s[0] != '#') return {};
  unsigned digits[8];
  const std::size_t count = s.size() - 1;
  if (count != 3 && count != 6 && count != 8) return {};
  for (std::size_t i = 0; i < count; i++) {
    const char c = s[i + 1];
    if (c >= '0' && c <= '9')
      digits[i] = static_cast<unsigned>(c - '0');
    else if ((c | 32) >= 'a' && (c | 32) <= 'f')
      digits[i] = static_cast<unsigned>((c | 32) - 'a' + 10);
    else
      return {};
  }
  float part[4] = {0, 0, 0, 1};
  for (std::size_t i = 0; i < (count == 8 ? 4 : 3); i++) {
    const unsigned byte = count == 3 ? digits[i] * 17 : digits[2 * i] * 16 + digits[2 * i + 1];
    part[i] = static_cast<float>(byte) / 255.0f;
  }
  return Color{part[0], part[1], part[2], part[3]};
}

}  // namespace pantin::fields
