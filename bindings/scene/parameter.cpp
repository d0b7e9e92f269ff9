#include "scene/parameter.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "scene/scene.hpp"

namespace pantin {
namespace {

/// Throws Error where a number is none of base, base ± step, base ± 2 step, …, up to round-off.
void check_step(const SceneParameter& p, double value) {
  if (!p.step) return;
  const double base = p.min.value_or(std::get<double>(p.initial)), step = *p.step;
  const double count = (value - base) / step, below = std::floor(count);
  const double round_off = 1e-9 * std::max(1.0, std::fabs(count));
  if (std::fabs(count - std::round(count)) <= round_off) return;
  throw Error(text(p.name, " goes in steps of ", step, " from ", base, ", so it must be ", base + below * step, " or ",
                   base + (below + 1) * step, ", got ", value));
}

}  // namespace

const char* type_name(const SceneValue& value) {
  if (std::holds_alternative<double>(value)) return "a number";
  return std::holds_alternative<bool>(value) ? "true or false" : "a string";
}

std::string unquoted(const std::string& given) {
  const bool quoted =
      given.size() >= 2 && (given.front() == '"' || given.front() == '\'') && given.back() == given.front();
  return quoted ? given.substr(1, given.size() - 2) : given;
}

std::optional<double> number_of_text(const std::string& given) {
  const auto read = [](std::string_view s) -> std::optional<double> {
    double value = 0.0;
    const auto result = std::from_chars(s.data(), s.data() + s.size(), value);
    if (s.empty() || result.ec != std::errc{} || result.ptr != s.data() + s.size()) return {};
    return value;
  };
  const std::string_view s = given;
  const auto slash = s.find('/');
  if (slash == s.npos) return read(s);
  const auto above = read(s.substr(0, slash)), below = read(s.substr(slash + 1));
  if (!above || !below) return {};
  return *above / *below;
}

SceneValue value_of_text(const SceneParameter& p, const std::string& given) {
  if (std::holds_alternative<std::string>(p.initial)) return unquoted(given);
  if (std::holds_alternative<bool>(p.initial)) {
    require(given == "true" || given == "false", p.name, " must be true or false, got '", given, "'");
    return given == "true";
  }
  const auto number = number_of_text(given);
  require(number.has_value(), p.name, " must be a number, got '", given, "'");
  return *number;
}

void check_allowed(const SceneParameter& p, const SceneValue& value) {
  require(value.index() == p.initial.index(), p.name, " must be ", type_name(p.initial), ", got ", type_name(value));
  if (const auto* number = std::get_if<double>(&value)) {
    require(std::isfinite(*number), p.name, " must be a finite number, got ", *number);
    require(!p.min || *number >= *p.min, p.name, " must be at least ", p.min.value_or(0), ", got ", *number);
    require(!p.max || *number <= *p.max, p.name, " must be at most ", p.max.value_or(0), ", got ", *number);
    check_step(p, *number);
  }
  if (p.choices.empty() || std::find(p.choices.begin(), p.choices.end(), value) != p.choices.end()) return;
  std::string names;
  for (const SceneValue& choice : p.choices) names += (names.empty() ? "" : ", ") + setting_text(choice);
  throw Error(text(p.name, " must be one of ", names, ", got ", setting_text(value)));
}

}  // namespace pantin
