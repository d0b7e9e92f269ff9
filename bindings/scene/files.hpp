#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "base/check.hpp"

namespace pantin {

/// A file has more bytes than are read.
struct FileTooLarge : Error {
  FileTooLarge(const std::string& path, std::size_t bytes, std::size_t largest);
};

/// All of a file, or nothing where there is none. May throw FileTooLarge where it has more than `largest` bytes.
using FileReader = std::function<std::optional<std::string>(const std::string& path, std::size_t largest)>;

/// All of a file, or nothing where it cannot be read. Throws FileTooLarge where it has more than `largest` bytes.
std::optional<std::string> file_content(const std::string& path,
                                        std::size_t largest = std::numeric_limits<std::size_t>::max());
/// Whether there is such a file and it holds something else. One of another size is not read.
bool holds_other(const std::string& path, const std::string& content);
/// "a" and "b" joined by a slash, or "b" where "a" is empty.
std::string path_in(const std::string& folder, const std::string& name);
/// Whether a relative path stays below the folder it begins in.
bool stays_inside(const std::string& path);
/// Whether a file lies below a folder once links are followed; so does one that is not there.
bool lies_below(const std::string& path, const std::string& folder);

}  // namespace pantin
