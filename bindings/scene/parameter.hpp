#pragma once
// What the parameters of a scene may be.
#include <optional>
#include <string>

#include "scene/options.hpp"

namespace pantin {

/// "a number", "true or false", "a string"
const char* type_name(const SceneValue& value);
/// A text without the quotes that a shell has left round it.
std::string unquoted(const std::string& given);
/// Reads a number as `--set` gives it: "0.5", "1/60".
std::optional<double> number_of_text(const std::string& given);
/// The value that a text of the command line means for a parameter. Throws Error.
SceneValue value_of_text(const SceneParameter& parameter, const std::string& given);
/// Throws Error where the value is not allowed.
void check_allowed(const SceneParameter& parameter, const SceneValue& value);

}  // namespace pantin
