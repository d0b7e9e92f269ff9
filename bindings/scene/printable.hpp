#pragma once
#include <string>
#include <string_view>

namespace pantin {

/// Text as a terminal may have it: what would command it (control characters but tab and new line, those that turn the
/// direction of reading or separate lines, bytes that are no UTF-8) is shown as `\x1b`.
std::string printable(std::string_view text);

}  // namespace pantin
