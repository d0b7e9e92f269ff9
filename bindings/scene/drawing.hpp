#pragma once
// What a scene draws beside its things, by `scene.draw`.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/color.hpp"
#include "base/lanes.hpp"

namespace pantin {

struct Drawing {
  enum class Kind : std::uint8_t { line, arrow, text, point };
  Kind kind = Kind::line;
  Vec3 from = zero3();  ///< [m], or on the screen [px] from its upper left corner, negative from the opposite edge
  Vec3 to = zero3();    ///< the same; of a line or arrow
  std::optional<Color> color;  ///< none: what shows on the background
  double size = 0.0;           ///< [px] width of a line, diameter of a point, height of letters
  bool on_screen = false;
  std::string text;
};

/// In one step; more are an error.
constexpr std::size_t most_drawings = 10000;
constexpr std::size_t longest_text = 1000;  ///< [bytes] of one

}  // namespace pantin
