#pragma once
// What a slider keeps: five ways of its point, along axes of its carrier, each by itself.
#include "model/constraint.hpp"

namespace pantin {

/// By their place in its list: two across its line, the way along it where that is kept, and the same up to its ends.
enum class SliderValue : std::uint8_t { across, across_too, along, to_max, to_min };
inline constexpr std::size_t slider_values = 5;

/// Whether a value of a slider is one of those that only stop it.
inline bool is_end_of_slider(const Constraint&, std::uint32_t index) {
  return index >= static_cast<std::uint32_t>(SliderValue::to_max);
}

}  // namespace pantin
