#pragma once
// What is made of the command line's own description, so that it has every option.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pantin::player {

/// A page for `man`, in its macros.
std::string manual_page(const CLI::App& program, const std::string& version);

/// A script that completes commands, options and the names of shipped scenes in bash.
std::string bash_completion(const CLI::App& program, const std::vector<std::string>& scenes);

}  // namespace pantin::player
