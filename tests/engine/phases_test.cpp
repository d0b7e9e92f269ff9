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

/// The first name in each row of the table below the heading "The step".
std::vector<std::string> phases_told(const std::string& page) {
  std::istringstream lines(page.substr(page.find("## The step")));
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line) && (names.empty() || line.starts_with("|"));) {
    const std::size_t begin = line.find('`') + 1;
    if (line.starts_with("|") && begin > 0) names.push_back(line.substr(begin, line.find('`', begin) - begin));
  }
  return names;
}

}  // namespace

TEST_CASE("phases: the step, the profiler and the house's page name the same ones in the same order") {
  const std::vector<std::string> names(phase_names.begin(), phase_names.end());
  CHECK(phases_called(text_of("engine/step/step.cpp")) == names);
  CHECK(phases_told(text_of("assets/pages/house.md")) == names);
}
