#include "player/test.hpp"

#include <cstdio>
#include <filesystem>

#include "lua/test/tests.hpp"
#include "player/confine.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

int test(const std::vector<std::string>& given, bool untrusted, const std::string& home) {
  std::vector<std::string> paths = given;
  if (paths.empty()) {
    std::string usual = std::filesystem::path(home) / "tests" / "scenes";
    if (!std::filesystem::is_directory(usual)) throw UsageError("give the files or folders to test");
    paths.push_back(usual);
  }
  SceneOptions options;
  options.home = home;
  if (untrusted) {
    RunOptions run;
    run.threads = options.threads;
    Reach reach = reach_of(run, "", home);
    for (const std::string& path : paths)
      reach.read.push_back(
          std::filesystem::is_directory(path) ? path : std::filesystem::absolute(path).parent_path().string());
    confine(reach);
  }
  lua::TestOutcome outcome = lua::run_tests(paths, options, stdout);
  if (outcome.passed + outcome.failed == 0) throw Error("there are no tests in " + paths.front());
  std::printf("%d passed, %d failed\n", outcome.passed, outcome.failed);
  return outcome.failed == 0 ? 0 : 1;
}

}  // namespace pantin::player
