#pragma once
// For the recordings alone.
#include <nlohmann/json.hpp>
#include <string>

namespace pantin::player {

using Json = nlohmann::ordered_json;

std::string letters_of(const std::string& bytes);
/// Throws Error where the text is none of these.
std::string bytes_of(const std::string& letters);
std::string hexadecimal(std::uint64_t value);
/// Throws Error where the text is no such number.
std::uint64_t from_hexadecimal(const std::string& text);

}  // namespace pantin::player
