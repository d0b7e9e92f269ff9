#include "lua/thing/scene_file.hpp"

#include "base/check.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/files.hpp"

namespace pantin::lua {

std::string read_scene_file(lua_State* state, const std::string& call, const char* assets, const std::string& name,
                            std::size_t largest) {
  require(stays_inside(name), call, ": '", name, "' must be a file below the scene's folder or assets/", assets,
          ", not an absolute path or one with ..");
  Runtime& runtime = Runtime::of(state);
  const std::string folders[] = {runtime.folder, path_in(runtime.home, text("assets/", assets))};
  const std::string places[] = {path_in(folders[0], name), path_in(folders[1], name)};
  for (std::size_t i = 0; i < std::size(places); i++) {
    const std::string& path = places[i];
    require(lies_below(path, folders[i]), call, ": '", name, "' leads out of its folder");
    if (const std::string* content = runtime.read(path, largest)) return *content;
  }
  throw Error(text(call, ": there is no file '", places[0], "' or '", places[1], "'"));
}

}  // namespace pantin::lua
