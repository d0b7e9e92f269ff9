#include "base/check_values.hpp"

#include <cmath>

#include "base/check.hpp"

namespace pantin::internal {

namespace {

std::string spaced(std::string_view unit) { return unit.empty() ? std::string() : text(" ", unit); }

}  // namespace

std::string to_text(Vec3 v) {
  return text("(", static_cast<double>(v[0]), ", ", static_cast<double>(v[1]), ", ", static_cast<double>(v[2]), ")");
}

void require_finite(std::string_view call, std::string_view name, Vec3 v, std::string_view unit) {
  if (!finite(v)) throw Error(text(call, ": ", name, " must be finite, got ", to_text(v), " ", unit));
}
void require_finite(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(std::isfinite(x), call, ": ", name, " must be finite, got ", x, " ", unit);
}
void require_positive(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x > 0.0 && std::isfinite(x), call, ": ", name, " must be > 0", spaced(unit), " and finite, got ", x);
}
void require_positive_or_infinite(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x > 0.0, call, ": ", name, " must be > 0", spaced(unit), ", got ", x);
}
void require_not_negative(std::string_view call, std::string_view name, double x, std::string_view unit) {
  require(x >= 0.0 && std::isfinite(x), call, ": ", name, " must be >= 0", spaced(unit), " and finite, got ", x);
}

void require_range(std::string_view call, double min, double max, std::string_view unit) {
  require(!std::isnan(min) && !std::isnan(max), call, ": min and max must be numbers [", unit, "]");
  require(min < max, call, ": min must be below max, got ", min, " and ", max, " ", unit);
  require(std::isfinite(min) || std::isfinite(max), call, ": min or max must be finite");
}

Vec3 unit_vector(std::string_view call, std::string_view name, Vec3 v) {
  require_finite(call, name, v, "");
  require(norm(v) > 0.0, call, ": ", name, " must not be vec(0, 0, 0)");
  return v / norm(v);
}

}  // namespace pantin::internal
