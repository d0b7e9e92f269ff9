#include "scene/printable.hpp"

#include <cstddef>
#include <cstdio>

namespace pantin {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// C0 and C1 but tab and new line, what turns the direction of reading, what ends lines elsewhere, and what XML takes for none.
bool commands(char32_t code) {
  if (code < 0x20) return code != '\n' && code != '\t';
  return (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfffe || code == 0xffff;
}

/// Bytes of the character that a text begins with; 0: it is one that commands, or none.
std::size_t shown_bytes(std::string_view text) {
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return commands(first) ? 0 : 1;
  const std::size_t count = first >= 0xf8 ? 0 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 0;
  if (count == 0 || text.size() < count) return 0;
  char32_t code = first & (0x7fu >> count);
  for (std::size_t i = 1; i < count; i++) {
    if (!continues(text[i])) return 0;
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3f);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code < least[count] || code > 0x10ffff || surrogate || commands(code) ? 0 : count;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    std::size_t count = shown_bytes(text);
    if (count > 0) {
      shown += text.substr(0, count);
    } else {
      char code[8];
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[0])));
      shown += code;
      count = 1;
    }
    text.remove_prefix(count);
  }
  return shown;
}

}  // namespace pantin
