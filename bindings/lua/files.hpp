#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pantin::lua {

/// All of a file, or nothing where it cannot be read.
std::optional<std::string> read_file(const std::string& path);
/// Tells whether two contents are the same.
std::uint64_t hash_of(std::string_view content);
/// "a" and "b" joined by a slash, or "b" where "a" is empty.
std::string path_in(const std::string& folder, const std::string& name);
/// Whether a relative path stays below the folder it begins in.
bool stays_inside(const std::string& path);

}  // namespace pantin::lua
