#pragma once
// What calls check of the numbers and vectors that they are given, and what they then say.
#include <string>
#include <string_view>

#include "base/lanes.hpp"

namespace pantin::internal {

std::string to_text(Vec3 v);
/// "<call>: <name> must be finite, got (NaN, 0, 0) m"
void require_finite(std::string_view call, std::string_view name, Vec3 v, std::string_view unit);
void require_finite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_positive(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Above zero, or infinite.
void require_positive_or_infinite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_not_negative(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Not NaN, `min` below `max`, one of them finite.
void require_range(std::string_view call, double min, double max, std::string_view unit);
/// A vector at unit length; throws Error where it has none.
Vec3 unit_vector(std::string_view call, std::string_view name, Vec3 v);

}  // namespace pantin::internal
