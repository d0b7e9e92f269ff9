#pragma once

namespace pantin {

/// Red, green, blue and opacity, 0 … 1 (sRGB).
struct Color {
  float r = 1.0f, g = 1.0f, b = 1.0f, a = 1.0f;
  friend bool operator==(const Color&, const Color&) = default;
};

}  // namespace pantin
