#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/color.hpp"

namespace pantin::fields {

/// "#rrggbb", or "#rrggbbaa" where it is not opaque.
std::string text_of(const Color& color);
/// Of "#rgb", "#rrggbb" or "#rrggbbaa".
std::optional<Color> color_of_text(std::string_view text);

}  // namespace pantin::fields
