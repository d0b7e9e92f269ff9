#pragma once
// Tests written in Lua: test(name, f), expect(x), open(path, params), open_text(source, params).
#include <cstdio>
#include <string>
#include <vector>

#include "scene/options.hpp"

namespace pantin::lua {

struct TestOutcome {
  int passed = 0;
  int failed = 0;
};

/// Runs the `.lua` files of the paths (files, or folders with all below), each in a state of its own. Each failure is
/// printed with file, line and message. Throws UsageError where a path does not exist.
TestOutcome run_tests(const std::vector<std::string>& paths, const SceneOptions& options, std::FILE* out);

}  // namespace pantin::lua
