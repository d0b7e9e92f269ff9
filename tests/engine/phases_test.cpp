#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "base/profile.hpp"
#include "support/sources.hpp"

using namespace pantin;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(sources::folder() + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Names in `phases::NAME(world)`, each where it first stands.
std::vector<std::string> phases_called(const std::string& source) {
  const std::string mark = "phases::";
  std::vector<std::string> names;
  for (std::size_t at = source.find(mark); at != std::string::npos; at = source.find(mark, at + 1)) {
    const std::size_t begin = at + mark.size(), end = source.find("(world)", begin);
    const std::string name = source.substr(begin, end - begin);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// Lines of the fenced block below the heading "The step".
std::vector<std::string> phases_told(const std::string& readme) {
  const std::size_t begin = readme.find("```text\n", readme.find("## The step")) + 8;
  std::istringstream lines(readme.substr(begin, readme.find("```", begin) - begin));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) names.push_back(line);
  return names;
}

}  // namespace

TEST_CASE("phases: the step, the profiler and the README name the same ones in the same order") {
  const std::vector<std::string> names(phase_names.begin(), phase_names.end());
  CHECK(phases_called(text_of("engine/step/step.cpp")) == names);
  CHECK(phases_told(text_of("README.md")) == names);
}
