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
                            "engine/shapes",
                            "engine/model",
                            "engine/laws",
                            "engine/laws/run",
                            "engine/constraints",
                            "engine/trees",
                            "engine/articulates",
                            "engine/articulates/solve",
                            "engine/articulates/build",
                            "engine/contacts/solve",
                            "engine/contacts",
                            "engine/world",
                            "engine/forces",
                            "engine/measure",
                            "engine/edit",
                            "engine/choreography",
                            "engine/snapshot",
                            "engine/structures",
                            "engine/step"};

const Names lua_order = {"bindings/lua/vm",    "bindings/lua/value", "bindings/lua/law",  "bindings/lua/library",
                         "bindings/lua/thing", "bindings/lua/scene", "bindings/lua/meta", "bindings/lua/test"};

// All that the program may know of Lua.
const Names lua_for_player = {"bindings/lua/scene/open.hpp", "bindings/lua/meta/annotations.hpp",
                              "bindings/lua/meta/reference.hpp", "bindings/lua/test/tests.hpp"};

// These include the engine alone; all others may include them.
const Names shared = {"bindings/fields", "bindings/scene"};

// Beginnings of headers from elsewhere that a folder must do without.
const std::map<std::string_view, Names> forbidden_headers = {
    {"engine", {"lua", "lauxlib", "SDL", "epoxy", "GL/", "imgui", "backends/", "stb_", "CLI/", "nlohmann", "iostream"}},
    {"bindings/fields", {"lua", "lauxlib", "SDL", "epoxy", "GL/", "imgui", "backends/", "stb_", "CLI/"}},
    {"bindings/scene", {"lua", "lauxlib", "SDL", "epoxy", "GL/", "imgui", "backends/", "stb_image_", "CLI/"}},
    {"bindings/lua", {"SDL", "epoxy", "GL/", "imgui", "backends/", "stb_", "CLI/"}},
    {"bindings/view", {"lua", "lauxlib", "CLI/"}},
    {"bindings/player", {"lua", "lauxlib"}},
};

const Names printing = {"printf(", "fprintf(", "puts(", "fputs(", "putchar(", "cout", "cerr", "clog"};

// "engine/edit/edit.cpp" lies in "engine/edit".
std::string folder_of(const std::string& path) { return fs::path(path).parent_path().generic_string(); }

bool lies_in(std::string_view folder, std::string_view whole) {
  return folder == whole || (folder.starts_with(whole) && folder[whole.size()] == '/');
}

bool is_engine(std::string_view folder) { return lies_in(folder, "engine"); }

// The order of the rooms that a folder is one of, or null.
const Names* order_of(std::string_view folder) {
  if (is_engine(folder)) return &engine_order;
  return lies_in(folder, "bindings/lua") ? &lua_order : nullptr;
}

bool is_among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether files in the folder `from` may include the file `target`.
bool may_include(std::string_view from, const std::string& target) {
  const std::string to = folder_of(target);
  const Names* order = order_of(from);
  if (order && order == order_of(to)) {
    const auto position = std::find(order->begin(), order->end(), from);
    return position != order->end() && std::find(order->begin(), position + 1, to) != position + 1;
  }
  if (is_engine(from)) return false;
  if (from == to || is_engine(to)) return true;
  if (is_among(shared, to)) return !is_among(shared, from);
  if (!lies_in(from, "bindings/player")) return false;
  return lies_in(to, "bindings/player") || to == "bindings/view" || is_among(lua_for_player, target);
}

// Of headers that files in a folder must do without; may be empty.
Names forbidden_in(std::string_view folder) {
  for (const auto& [whole, headers] : forbidden_headers)
    if (lies_in(folder, whole)) return headers;
  return {};
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
  if (!target.empty() && !may_include(from, target)) wrong.push_back(path + " must not include " + target);
  if (name.starts_with("gemmi/") && path != "engine/structures/molecule_gemmi.cpp")
    wrong.push_back(path + " must not include " + name);
  if (name == "tiny_obj_loader.h" && path != "engine/structures/mesh_file.cpp")
    wrong.push_back(path + " must not include " + name);
  if (name == "stb_image.h" && from == "bindings/scene" && path != "bindings/scene/picture_file.cpp")
    wrong.push_back(path + " must not include " + name);
  if (!target.empty()) return;
  for (const auto start : forbidden_in(from)) {
    if (name.starts_with(start)) wrong.push_back(path + " must not include " + name);
  }
}

std::vector<std::string> wrong_arrows(const Files& files) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : files) {
    const std::string folder = folder_of(path);
    const Names* order = order_of(folder);
    if (order && !is_among(*order, folder)) wrong.push_back(path + " lies in a folder without a position in the order");
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
      {"bindings/scene/options.hpp", "#include \"world/world.hpp\"\n"},
      {"bindings/fields/value.hpp", "#include \"world/world.hpp\"\n"},
      {"bindings/view/panel.cpp", "#include \"fields/value.hpp\"\n"},
      {"bindings/lua/vm/state.hpp", "#include <lua.hpp>\n#include \"step/step.hpp\"\n"},
      {"bindings/lua/thing/body.hpp", "#include \"lua/vm/state.hpp\"\n#include \"scene/options.hpp\"\n"},
      {"bindings/view/camera.hpp", "#include <SDL.h>\n#include \"scene/options.hpp\"\n"},
      {"bindings/lua/scene/open.hpp", "#include \"lua/thing/body.hpp\"\n"},
      {"bindings/player/main.cpp", "#include \"lua/scene/open.hpp\"\n#include \"view/camera.hpp\"\n"},
  };
  CHECK(wrong_arrows(files) == std::vector<std::string>());

  const auto [path, text, complaint] = GENERATE(table<std::string, std::string, std::string>({
      {"engine/laws/library.hpp", "#include \"world/world.hpp\"", "must not include engine/world/world.hpp"},
      {"engine/laws/library.hpp", "#  include \"../world/world.hpp\"", "must not include engine/world/world.hpp"},
      {"engine/forces/kick.cpp", "#include \"step/step.hpp\"", "must not include engine/step/step.hpp"},
      {"engine/base/check.hpp", "#include \"lua/vm/state.hpp\"", "must not include bindings/lua/vm/state.hpp"},
      {"engine/base/check.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"engine/base/check.hpp", "#include <SDL.h>", "must not include SDL.h"},
      {"engine/base/check.hpp", "#include <iostream>", "must not include iostream"},
      {"engine/base/check.hpp", "#include <gemmi/cif.hpp>", "must not include gemmi/cif.hpp"},
      {"engine/base/check.hpp", "  std::printf(\"x\");", "must not print"},
      {"engine/base/check.hpp", "  std::cerr << 1;", "must not print"},
      {"engine/extra/thing.hpp", "", "without a position in the order"},
      {"engine/base/check.hpp", "#include \"scene/options.hpp\"", "must not include bindings/scene/options.hpp"},
      {"bindings/scene/options.hpp", "#include \"lua/vm/state.hpp\"", "must not include bindings/lua/vm/state.hpp"},
      {"bindings/scene/options.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"bindings/fields/value.hpp", "#include \"lua/vm/state.hpp\"", "must not include bindings/lua/vm/state.hpp"},
      {"bindings/fields/value.hpp", "#include \"scene/options.hpp\"", "must not include bindings/scene/options.hpp"},
      {"bindings/fields/value.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"engine/base/check.hpp", "#include \"fields/value.hpp\"", "must not include bindings/fields/value.hpp"},
      {"bindings/lua/vm/state.hpp", "#include \"lua/thing/body.hpp\"", "must not include bindings/lua/thing/body.hpp"},
      {"bindings/lua/body.hpp", "", "without a position in the order"},
      {"bindings/lua/vm/state.hpp", "#include \"view/camera.hpp\"", "must not include bindings/view/camera.hpp"},
      {"bindings/lua/vm/state.hpp", "#include <SDL.h>", "must not include SDL.h"},
      {"bindings/view/camera.hpp", "#include \"lua/vm/state.hpp\"", "must not include bindings/lua/vm/state.hpp"},
      {"bindings/view/camera.hpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"bindings/player/main.cpp", "#include \"lua/vm/state.hpp\"", "must not include bindings/lua/vm/state.hpp"},
      {"bindings/player/main.cpp", "#include <lua.hpp>", "must not include lua.hpp"},
      {"bindings/view/camera.hpp", "#include \"player/main.cpp\"", "must not include bindings/player/main.cpp"},
  }));
  INFO(path << ": " << text);
  files[path] = text + "\n";
  const auto wrong = wrong_arrows(files);
  REQUIRE(wrong.size() == 1);
  CHECK_THAT(wrong[0], Catch::StartsWith(path) && Catch::Contains(complaint));
}
