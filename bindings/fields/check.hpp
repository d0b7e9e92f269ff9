#pragma once
#include <string>
#include <string_view>

#include "base/lanes.hpp"

namespace pantin::fields {

/// Throw Error, "body: mass must be a finite number [kg], got NaN", where they are not finite.
void check_finite(double value, std::string_view what, std::string_view name, std::string_view unit);
void check_finite(Vec3 value, std::string_view what, std::string_view name, std::string_view unit);
/// " [kg]", or nothing.
std::string in_brackets(std::string_view unit);

}  // namespace pantin::fields
