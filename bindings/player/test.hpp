#pragma once
#include <string>
#include <vector>

namespace pantin::player {

/// `pantin test`: the tests in Lua under the paths, which may be a stranger's. Returns the exit code.
int test(const std::vector<std::string>& paths, bool untrusted, const std::string& home);

}  // namespace pantin::player
