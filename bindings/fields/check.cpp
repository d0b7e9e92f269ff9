#include "fields/check.hpp"

#include <cmath>

#include "base/check.hpp"

namespace pantin::fields {

void check_finite(double value, std::string_view what, std::string_view name, std::string_view unit) {
  require(std::isfinite(value), what, ": ", name, " must be a finite number", in_brackets(unit), ", got ", value);
}

void check_finite(Vec3 value, std::string_view what, std::string_view name, std::string_view unit) {
  require(finite(value), what, ": ", name, " must be a finite vec", in_brackets(unit), ", got vec(", to_text(value[0]),
          ", ", to_text(value[1]), ", ", to_text(value[2]), ")");
}

std::string in_brackets(std::string_view unit) { return unit.empty() ? "" : text(" [", unit, "]"); }

}  // namespace pantin::fields
