#include "lua/thing/script.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "lua/library/sandbox.hpp"

namespace pantin::lua {

Script::Script(const SceneOptions& given)
    : ScriptHost{given, Runtime({given.script_limit, given.memory_limit}, sandbox)} {
  world.workers = std::make_unique<Workers>(options.threads);
  runtime.random = &world.random;
  runtime.home = given.home;
  if (!options.saved) options.saved = std::make_shared<SavedValues>();
  if (given.read) runtime.reader = given.read;
  runtime.on_read = given.on_read;
  runtime.notice = [this](const std::string& notice) {
    const auto is_it = [&](const LogLine& line) { return line.text == notice; };
    if (std::ranges::none_of(world.log, is_it)) log_line(world, "notice", notice);
  };
  world.random = Random{world.settings.seed, 0};
  world.who = [] {
    const Runtime* running = Runtime::current();
    return running ? where(running->active()) : std::string{};
  };
}

Script& script_of(lua_State* state) { return *static_cast<Script*>(lua_touserdata(state, lua_upvalueindex(1))); }

}  // namespace pantin::lua
