#include "laws/parameter.hpp"

#include <cmath>

#include "base/check.hpp"
#include "laws/law.hpp"

namespace pantin {
namespace {

using Range = ParameterRange;

bool is_within(double value, Range range) {
  if (!std::isfinite(value)) return false;
  switch (range) {
    case Range::any:
    case Range::direction: return true;
    case Range::positive: return value > 0.0;
    case Range::not_negative: return value >= 0.0;
    case Range::sign: return value >= -1.0 && value <= 1.0;
    case Range::whole: return value >= 1.0 && value == std::floor(value);
  }
  return false;
}

const char* words_for(Range range) {
  switch (range) {
    case Range::any:
    case Range::direction: return "finite";
    case Range::positive: return "> 0";
    case Range::not_negative: return ">= 0";
    case Range::sign: return "from -1 to 1";
    case Range::whole: return "a whole number >= 1";
  }
  return "";
}

/// The three parts of a vec, of which one is at `index`.
void check_direction(std::string_view before, std::span<const Parameter> parameters, std::span<const double> values,
                     std::size_t index) {
  const std::string& name = parameters[index].name;
  const std::size_t part = name.empty() ? 3 : static_cast<std::size_t>(name.back() - 'x');
  if (part > 2 || part > index || index - part + 3 > values.size()) return;  // only in a state that was forged
  const std::span<const double> v = values.subspan(index - part, 3);
  require(v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0, before, name.substr(0, name.size() - 2),
          " must not be 0, and with ", name, " = 0 all its parts are");
}

}  // namespace

void check_parameter(std::string_view call, const std::string& law, std::span<const Parameter> parameters,
                     std::span<const double> values, std::size_t index) {
  const Parameter& parameter = parameters[index];
  if (given_by_world(parameter.name)) return;
  const std::string before = text(call, call.empty() ? "" : ": ", law, ": ");
  const bool has_unit = !parameter.unit.empty() && parameter.unit != "1";
  require(is_within(values[index], parameter.range), before, parameter.name, " must be ", words_for(parameter.range),
          has_unit ? " " : "", has_unit ? parameter.unit : "", ", got ", values[index]);
  if (parameter.range == Range::direction) check_direction(before, parameters, values, index);
}

void check_parameters(std::string_view call, const std::string& law, std::span<const Parameter> parameters,
                      std::span<const double> values) {
  for (std::size_t i = 0; i < parameters.size(); i++) check_parameter(call, law, parameters, values, i);
}

}  // namespace pantin
