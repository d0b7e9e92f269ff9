#include "player/sweep/look.hpp"

#include <algorithm>
#include <cmath>

#include "lua/scene/open.hpp"
#include "player/csv.hpp"
#include "player/json.hpp"
#include "scene/errors.hpp"
#include "scene/parameter.hpp"

namespace pantin::player {
namespace {

/// Throws UsageError where a parameter does not take what it is to be.
void check_range(const Axis& axis, const ParameterLook& parameter) {
  std::vector<double> all = {axis.from, axis.to};
  if (!axis.values.empty()) all.clear();
  for (const std::string& value : axis.values)
    if (const auto number = number_or_fraction(value)) all.push_back(*number);
  for (const double value : all) {
    if (parameter.min && value < *parameter.min)
      throw UsageError(text(axis.name, " must be at least ", *parameter.min, ", got ", value));
    if (parameter.max && value > *parameter.max)
      throw UsageError(text(axis.name, " must be at most ", *parameter.max, ", got ", value));
  }
}

/// Why one of the values is none that the parameter takes; empty: all are.
std::string why_not(const Axis& axis, const SceneParameter& parameter) {
  for (const std::string& value : axis.values) try {
      check_allowed(parameter, value_of_text(parameter, value));
    } catch (const Error& error) { return text("--set ", axis.name, "=", value, ": ", error.what()); }
  return "";
}

/// What the scene says of a parameter that it has not.
std::string why_unknown(const Axis& axis, const std::string& path, SceneOptions options) {
  options.set[axis.name] = number_text(axis.from);
  try {
    lua::open_scene(path, options);
  } catch (const UsageError& error) { return error.what(); }
  return text("the scene has no parameter '", axis.name, "'");
}

Json json_of_bound(const std::optional<double>& bound) { return bound ? Json(*bound) : Json(); }

std::optional<double> bound_of(const Json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

}  // namespace

SceneLook look_at_scene(const std::vector<Axis>& axes, const std::string& path, const SceneOptions& limits) {
  SceneOptions first = limits;
  for (const Axis& axis : axes)
    if (!axis.values.empty() || axis.whole)
      first.set[axis.name] = axis.value(0);
    else if (axis.name.starts_with("scene."))
      first.set[axis.name] = number_text(axis.from);
  SceneLook look;
  for (const SceneOptions& tried : {first, limits}) try {
      const auto scene = lua::open_scene(path, tried);
      for (const SceneParameter& p : scene->parameters()) {
        look.parameters[p.name] = {p.min, p.max, p.integer};
        for (const Axis& axis : axes)
          if (axis.name == p.name && look.unknown.empty()) look.unknown = why_not(axis, p);
      }
      for (const Axis& axis : axes)
        if (!look.parameters.contains(axis.name) && !axis.name.starts_with("scene."))
          look.unknown = why_unknown(axis, path, limits);
      break;
    } catch (const UsageError& error) {
      look.unknown = error.what();
      break;
    } catch (const Error&) {}  // where neither can be opened the cases tell, each its own
  return look;
}

std::string text_of(const SceneLook& look) {
  Json parameters = Json::object();
  for (const auto& [name, p] : look.parameters)
    parameters[name] = {{"min", json_of_bound(p.min)}, {"max", json_of_bound(p.max)}, {"integer", p.integer}};
  return text_of(Json{{"parameters", parameters}, {"unknown", look.unknown}, {"lacks", look.lacks}});
}

SceneLook look_of(const std::string& told) {
  try {
    const Json json = Json::parse(told);
    SceneLook look{{}, json.at("unknown"), json.at("lacks")};
    for (const auto& [name, p] : json.at("parameters").items())
      look.parameters[name] = {bound_of(p.at("min")), bound_of(p.at("max")), p.at("integer")};
    return look;
  } catch (const Json::exception& error) { throw Error(text("that is no look at a scene: ", error.what())); }
}

void settle_whole(std::vector<Axis>& axes, const SceneLook& look) {
  if (!look.unknown.empty()) throw UsageError(look.unknown);
  for (Axis& axis : axes) {
    const auto known = look.parameters.find(axis.name);
    if (known == look.parameters.end()) continue;
    check_range(axis, known->second);
    if (!known->second.integer || !axis.values.empty()) continue;
    axis.whole = true;
    if (std::ceil(std::min(axis.from, axis.to)) > std::floor(std::max(axis.from, axis.to)))
      throw UsageError(text("'", axis.name,
                            "' is a whole number in this scene, as its default has no point: there is none "
                            "from ",
                            axis.from, " to ", axis.to));
    if (static_cast<double>(axis.count) > std::abs(axis.to - axis.from) + 1.0)
      throw UsageError(text("'", axis.name,
                            "' is a whole number in this scene, as its default has no point: there are no ", axis.count,
                            " of them from ", axis.from, " to ", axis.to));
  }
}

}  // namespace pantin::player
