#include "scene/printable.hpp"

#include <cstddef>
#include <cstdio>

namespace pantin {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Bytes of the character that a text begins with; 0: it is one that commands, or none.
std::size_t shown_bytes(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first == '\n' || first == '\t' || (first >= 0x20 && first != 0x7f) ? 1 : 0;
  const std::size_t count = first >= 0xf5 ? 0 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (count == 0 || text.size() < count) return 0;
  for (std::size_t i = 1; i < count; i++)
    if (!continues(text[i])) return 0;
  const bool second_controls = first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0;  // C1, as a terminal's CSI
  return second_controls ? 0 : count;
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
