// `require "name"`: the scene's own folder, then the libraries that come with the program.
#include <algorithm>
#include <filesystem>

#include "lua/library/sandbox.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/files.hpp"

namespace pantin::lua {
namespace {

const char loading = 0;

/// Upvalue 1: what was loaded, by path.
int require_file(lua_State* state) {
  Runtime& runtime = Runtime::of(state);
  const std::string name = check_text(state, 1, "require", "argument 1");
  std::string path = name;
  if (path.find('/') == std::string::npos) std::replace(path.begin(), path.end(), '.', '/');
  require(!name.starts_with('.') && stays_inside(path), "require: '", name,
          "' must be a name like \"grid\" or \"folder.grid\", not an absolute path or one with ..");
  path += ".lua";
  const std::string folders[] = {runtime.folder.empty() ? "." : runtime.folder, path_in(runtime.home, "scripts/lib"),
                                 path_in(runtime.home, "scripts/behaviours")};
  std::string places;
  for (const std::string& folder : folders) {
    const std::string file = path_in(folder, path);
    if (lua_getfield(state, lua_upvalueindex(1), file.c_str()) != LUA_TNIL) {
      require(lua_touserdata(state, -1) != &loading, "require: '", name, "' requires itself");
      return 1;
    }
    lua_pop(state, 1);
    require(lies_below(file, folder), "require: '", file, "' leads out of its folder");
    const std::string* source = runtime.read(file, largest_source);
    places += (places.empty() ? "" : ", ") + file;
    if (!source) continue;
    lua_pushlightuserdata(state, const_cast<char*>(&loading));
    lua_setfield(state, lua_upvalueindex(1), file.c_str());
    Runtime::of(state).load(state, *source, std::filesystem::path(path).filename());
    lua_pushvalue(state, 1);
    lua_call(state, 1, 1);
    if (lua_isnil(state, -1)) {
      lua_pop(state, 1);
      lua_pushboolean(state, 1);
    }
    lua_pushvalue(state, -1);
    lua_setfield(state, lua_upvalueindex(1), file.c_str());
    return 1;
  }
  throw Error(text("require: there is no '", name, "'; looked for ", places));
}

}  // namespace

void open_require(lua_State* state) {
  lua_newtable(state);
  lua_pushcclosure(state, guard<require_file>, 1);
  lua_setglobal(state, "require");
}

}  // namespace pantin::lua
