#include "lua/test/tests.hpp"

#include <algorithm>
#include <filesystem>

#include "lua/library/sandbox.hpp"
#include "lua/scene/open.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/saved_type.hpp"
#include "lua/scene/script_scene.hpp"
#include "lua/test/expect.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "scene/files.hpp"
#include "scene/printable.hpp"

namespace pantin::lua {
namespace {

/// One file of tests.
struct TestFile {
  TestFile(std::string path_given, const SceneOptions& given)
      : path(std::move(path_given)), options(given), runtime({given.script_limit, given.memory_limit}, sandbox) {
    runtime.random = &random;
    runtime.home = given.home;
    runtime.folder = std::filesystem::path(path).parent_path();
  }

  struct Test {
    std::string name;
    std::string place;
    Callback body;
  };

  std::string path;
  SceneOptions options;
  Random random;
  std::vector<std::unique_ptr<Scene>> scenes;  ///< that tests opened; their things are in variables of the runtime
  Runtime runtime;
  std::vector<Test> tests;
};

TestFile& file_of(lua_State* state) { return *static_cast<TestFile*>(lua_touserdata(state, lua_upvalueindex(1))); }

int declare_test(lua_State* state) {
  TestFile& file = file_of(state);
  check_count(state, 2, "test");
  const std::string name = check_text(state, 1, "test", "argument 1, the name,");
  file.tests.push_back({name, where(state), check_function(state, 2, "test", "argument 2")});
  return 0;
}

std::string text_of_value(lua_State* state, int index, const std::string& name) {
  if (lua_isboolean(state, index)) return lua_toboolean(state, index) ? "true" : "false";
  if (lua_type(state, index) == LUA_TNUMBER) return to_text(lua_tonumber(state, index));
  if (const auto v = to_vec(state, index)) return text(to_text((*v)[0]), ",", to_text((*v)[1]), ",", to_text((*v)[2]));
  return check_text(state, index, "open", text("parameter ", name));
}

SceneOptions options_with(lua_State* state, int index, const char* call, const SceneOptions& usual) {
  SceneOptions options = usual;
  options.set_by = text(call, ": ");
  each_given(state, index, call, given_what,
             [&](const std::string& name) { options.set[name] = text_of_value(state, lua_gettop(state), name); });
  give_saved(state, index + 1, call, options);
  return options;
}

void push_opened(lua_State* state, TestFile& file, std::unique_ptr<Scene> scene) {
  file.scenes.push_back(std::move(scene));
  auto* ref = static_cast<Ref*>(lua_newuserdatauv(state, sizeof(Ref), 0));
  *ref = make_ref(script_of(*file.scenes.back()), Kind::scene, 1, 1, 1);
  push_metatable(state, type_of_opened_scene());
  lua_setmetatable(state, -2);
}

int open_file(lua_State* state) {
  TestFile& file = file_of(state);
  check_count(state, 3, "open");
  const std::string name = check_text(state, 1, "open", "argument 1, the path,");
  const SceneOptions options = options_with(state, 2, "open", file.options);
  std::error_code error;
  std::string path = path_in(path_in(file.options.home, "scripts"), name);
  if (name.starts_with('/'))
    path = name;
  else if (!std::filesystem::exists(path, error))
    path = path_in(file.runtime.folder, name);
  push_opened(state, file, open_scene(path, options));
  return 1;
}

int open_source(lua_State* state) {
  TestFile& file = file_of(state);
  check_count(state, 3, "open_text");
  const std::string source = check_text(state, 1, "open_text", "argument 1");
  const SceneOptions options = options_with(state, 2, "open_text", file.options);
  push_opened(state, file, open_scene_text(source, "text.lua", file.runtime.folder, options));
  return 1;
}

void open_testing(lua_State* state, TestFile& file) {
  const luaL_Reg functions[] = {
      {"test", guard<declare_test>}, {"open", guard<open_file>}, {"open_text", guard<open_source>}};
  for (const luaL_Reg& function : functions) {
    lua_pushlightuserdata(state, &file);
    lua_pushcclosure(state, function.func, 1);
    lua_setglobal(state, function.name);
  }
  open_expect(state);
}

void run_file(const std::string& path, const SceneOptions& options, std::FILE* out, TestOutcome& outcome) {
  const int failed_before = outcome.failed;
  const auto fail = [&](const std::string& place, const std::string& name, const std::string& message) {
    outcome.failed++;
    std::fputs(printable(text("FAILED ", place, name.empty() ? "" : ": ", name, "\n  ", message, "\n")).c_str(), out);
  };
  TestFile file(path, options);
  try {
    const auto source = file_content(path);
    require(source.has_value(), path, ": cannot be read");
    file.runtime.run([&](lua_State* state) {
      open_testing(state, file);
      file.runtime.load(state, *source, std::filesystem::path(path).filename());
      lua_call(state, 0, 0);
    });
    require(!file.tests.empty(), path, ": has no test(name, function)");
  } catch (const std::exception& error) { fail(path, "", error.what()); }
  for (std::size_t i = 0; i < file.tests.size(); i++) {
    const TestFile::Test test = file.tests[i];  // one that is declared in another runs after it, and moves the list
    try {
      test.body.call();
      outcome.passed++;
    } catch (const std::exception& error) { fail(test.place, test.name, error.what()); }
  }
  std::fprintf(out, "%s: %zu tests, %d failed\n", printable(path).c_str(), file.tests.size(),
               outcome.failed - failed_before);
  std::fflush(out);
}

}  // namespace

TestOutcome run_tests(const std::vector<std::string>& paths, const SceneOptions& options, std::FILE* out) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      if (!fs::exists(path, error)) throw UsageError(text(path, ": there is no such file or folder"));
      files.push_back(path);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied))
      if (std::error_code unknown; entry.is_regular_file(unknown) && entry.path().extension() == ".lua")
        found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  TestOutcome outcome;
  for (const std::string& file : files) run_file(file, options, out, outcome);
  return outcome;
}

}  // namespace pantin::lua
