#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/sources.hpp"

namespace {

namespace fs = std::filesystem;

using pantin::sources::Files;
using Names = std::vector<std::string_view>;

// Each may include itself and those to its left.
const Names engine_order = {"engine/base",
                            "engine/model",
                            "engine/laws",
                            "engine/laws/run",
                            "engine/constraints",
                            "engine/articulates",
                            "engine/articulates/solve",
                            "engine/articulates/build",
                            "engine/world",
                            "engine/forces",
                            "engine/measure",
                            "engine/edit",
                            "engine/choreography",
                            "engine/snapshot",
                            "engine/structures",
                            "engine/step"};

// Beginnings of headers from elsewhere that a folder must do without.
const std::map<std::string_view, Names> forbidden_headers = {
    {"engine", {"lua", "lauxlib", "SDL", "epoxy", "GL/", "imgui", "backends/", "stb_", "CLI/", "nlohmann", "iostream"}},
    {"bindings/lua", {"SDL", "epoxy", "GL/", "imgui", "backends/", "stb_", "CLI/"}},
    {"bindings/view", {"lua", "lauxlib", "CLI/"}},
};

const Names printing = {"printf(", "fprintf(", "puts(", "fputs(", "putchar(", "cout", "cerr", "clog"};

// "engine/edit/edit.cpp" lies in "engine/edit".
std::string folder_of(const std::string& path) { return fs::path(path).parent_path().generic_string(); }

bool is_engine(std::string_view folder) { return folder == "engine" || folder.starts_with("engine/"); }

bool may_include(std::string_view from, std::string_view to) {
  if (is_engine(from)) {
    const auto position = std::find(engine_order.begin(), engine_order.end(), from);
    return position != engine_order.end() && std::find(engine_order.begin(), position + 1, to) != position + 1;
  }
  if (from == to || is_engine(to)) return true;
  return (from == "bindings/player" || from == "bindings/player/panels") && to.starts_with("bindings/");
}

// The file that `#include "name"` in `path` means, or nothing.
std::string find_included(const Files& files, const std::string& path, const std::string& name) {
  for (const std::string& start : {folder_of(path), std::string("engine"), std::string("bindings")}) {
    std::string candidate = (fs::path(start) / name).lexically_normal().generic_string();
    if (files.contains(candidate)) return candidate;
  }
  return {};
}

// The name that an include directive names, or nothing.
std::string included_name(std::string line) {
  std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
  if (!line.starts_with("#include")) return {};
  const auto start = line.find_first_of("<\""), end = line.find_last_of(">\"");
  return start < end ? line.substr(start + 1, end - start - 1) : std::string();
}

bool has_word(const std::string& line, std::string_view word) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool ends = !is_part(word.back()) || end == line.size() || !is_part(line[end]);
    if (ends && (at == 0 || !is_part(line[at - 1]))) return true;
  }
  return false;
}

void check_include(const Files& files, const std::string& path, const std::string& name,
                   std::vector<std::string>& wrong) {
  const std::string from = folder_of(path);
  const std::string target = find_included(files, path, name);
  if (!target.empty() && !may_include(from, folder_of(target))) wrong.push_back(path + " must not include " + target);
  if (name.starts_with("gemmi/") && path != "engine/structures/molecule_gemmi.cpp")
    wrong.push_back(path + " must not include " + name);
  const auto forbidden = forbidden_headers.find(is_engine(from) ? "engine" : std::string_view(from));
  if (!target.empty() || forbidden == forbidden_headers.end()) return;
  for (const auto start : forbidden->second) {
    if (name.starts_with(start)) wrong.push_back(path + " must not include " + name);
  }
}

std::vector<std::string> wrong_arrows(const Files& files) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : files) {
    const std::string folder = folder_of(path);
    if (is_engine(folder) && std::find(engine_order.begin(), engine_order.end(), folder) == engine_order.end()) {
      wrong.push_back(path + " lies in a folder without a position in the order");
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      line = line.substr(0, line.find("//"));
      if (const std::string name = included_name(line); !name.empty()) check_include(files, path, name, wrong);
      if (!is_engine(folder)) continue;
      for (const auto word : printing) {
        if (has_word(line, word)) wrong.push_back(path + " must not print: " + line);
      }
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("includes go one way only") {
  const Files files = pantin::sources::read({"engine", "bindings"});
  REQUIRE(!files.empty());
  CHECK(wrong_arrows(files) == std::vector<std::string>());
}

TEST_CASE("an include the wrong way is found") {
  Files files = {
      {"engine/base/check.hpp", "#include <string>\n"},
      {"engine/base/lanes.hpp", "#include \"base/check.hpp\"\n#include \"check.hpp\"\n"},
      {"engine/world/world.hpp", "#include \"laws/library.hpp\"\n"},
      {"engine/laws/library.hpp", "std::snprintf(text, size, form);  // not printf(form)\n"},
      {"engine/step/step.hpp", ""},
      {"engine/step/step.cpp", "#include \"step/step.hpp\"\n#include \"world/world.hpp\"\n"},
      {"bindings/lua/state.hpp", "#include <lua.hpp>\n#include \"step/step.hpp\"\n"},
      {"bindings/view/camera.hpp", "#include <SDL.h>\n#include \"world/world.hpp\"\n"},
      {"bindings/player/main.cpp", "#include \"lua/state.hpp\"\n#include \"view/camera.hpp\"\n"},
  };
  CHECK(wrong_arrows(files) == std::vector<std::string>());

  const auto [path, text, complaint] = GENERATE(table<std::string, std::string, std::string>({
      {"engine/laws/library.hpp", "#include \"world/world.hpp\"", "must not include engine/world/world.hpp"},
      {"engine/laws/library.hpp", "#  include \"../world/world.hpp\"", "must not include engine/world/world.hpp"},
      {"engine/forces/kick.cpp", "#include \"step/step.hpp\"", "must not include engine/step/step.hpp"},
      {"engine/base/check.hpp", "#include \"lua/state.hpp\"", "must not include bindings/lua/state.hpp"},
      {"engine/base/check.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"engine/base/check.hpp", "#include <SDL.h>", "must not include SDL.h"},
      {"engine/base/check.hpp", "#include <iostream>", "must not include iostream"},
      {"engine/base/check.hpp", "#include <gemmi/cif.hpp>", "must not include gemmi/cif.hpp"},
      {"engine/base/check.hpp", "  std::printf(\"x\");", "must not print"},
      {"engine/base/check.hpp", "  std::cerr << 1;", "must not print"},
      {"engine/extra/thing.hpp", "", "without a position in the order"},
      {"bindings/lua/state.hpp", "#include \"view/camera.hpp\"", "must not include bindings/view/camera.hpp"},
      {"bindings/lua/state.hpp", "#include <SDL.h>", "must not include SDL.h"},
      {"bindings/view/camera.hpp", "#include \"lua/state.hpp\"", "must not include bindings/lua/state.hpp"},
      {"bindings/view/camera.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"bindings/view/camera.hpp", "#include \"player/main.cpp\"", "must not include bindings/player/main.cpp"},
  }));
  INFO(path << ": " << text);
  files[path] = text + "\n";
  const auto wrong = wrong_arrows(files);
  REQUIRE(wrong.size() == 1);
  CHECK_THAT(wrong[0], Catch::StartsWith(path) && Catch::Contains(complaint));
}
