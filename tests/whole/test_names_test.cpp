#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "support/sources.hpp"

namespace {

namespace fs = std::filesystem;

using pantin::sources::Files;

struct Tested {
  std::string name;
  std::vector<std::string_view> folders;
};

// What the name of a test says that it tests, and where that is to be.
Tested tested_by(const std::string& folder, std::string name) {
  name.resize(name.size() - std::string_view("_test").size());
  if (folder == "tests/engine") return {name, {"engine/"}};
  if (folder == "tests/window") return {name, {"bindings/view/", "bindings/player/"}};
  if (folder == "tests/support") return {name, {"tests/support/", "tests/peers/"}};
  if (name.starts_with("lua_")) return {name.substr(4), {"bindings/lua/"}};
  if (name.starts_with("player_")) return {name.substr(7), {"bindings/player/"}};
  return {name, {"bindings/fields/", "bindings/scene/"}};
}

bool has(const Files& files, const Tested& tested) {
  return std::any_of(files.begin(), files.end(), [&](const auto& file) {
    const auto lies_in = [&](std::string_view folder) { return file.first.starts_with(folder); };
    return fs::path(file.first).stem() == tested.name &&
           std::any_of(tested.folders.begin(), tested.folders.end(), lies_in);
  });
}

std::vector<std::string> tests_of_no_file(const Files& files) {
  std::vector<std::string> found;
  for (const auto& [path, text] : files) {
    const std::string folder = fs::path(path).parent_path().generic_string();
    if (!path.starts_with("tests/") || !path.ends_with("_test.cpp") || folder == "tests/whole") continue;
    if (!has(files, tested_by(folder, fs::path(path).stem().string()))) found.push_back(path);
  }
  return found;
}

}  // namespace

TEST_CASE("each test is named after a file that it tests, or is one of the whole") {
  CHECK(tests_of_no_file(pantin::sources::read({"engine", "bindings", "tests"})) == std::vector<std::string>());
}

TEST_CASE("a test that is named after no file is found") {
  Files files;
  for (const char* path : {"engine/constraints/rod.cpp", "bindings/lua/vm/guard.hpp", "bindings/player/run.cpp",
                           "bindings/view/pick.hpp", "bindings/scene/scene.cpp", "tests/engine/rod_test.cpp",
                           "tests/bindings/lua_guard_test.cpp", "tests/bindings/player_run_test.cpp",
                           "tests/bindings/scene_test.cpp", "tests/window/pick_test.cpp", "tests/whole/scale_test.cpp"})
    files[path];
  CHECK(tests_of_no_file(files).empty());
  const std::string wrong =
      GENERATE("tests/engine/rods_test.cpp", "tests/engine/guard_test.cpp", "tests/bindings/lua_run_test.cpp",
               "tests/bindings/pick_test.cpp", "tests/window/rod_test.cpp", "tests/new/rod_test.cpp");
  files[wrong];
  CHECK(tests_of_no_file(files) == std::vector<std::string>{wrong});
}
