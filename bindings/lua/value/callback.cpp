#include "lua/value/callback.hpp"

#include "lua/value/arguments.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {

struct Callback::Held {
  Runtime& runtime;
  int reference;
  std::string place;
  ~Held() { luaL_unref(runtime.active(), LUA_REGISTRYINDEX, reference); }
};

Callback::Callback(lua_State* state, int index) {
  lua_pushvalue(state, index);
  lua_Debug function;
  lua_pushvalue(state, index);
  lua_getinfo(state, ">S", &function);
  std::string place = function.linedefined > 0 ? text(function.short_src, ":", function.linedefined) : where(state);
  held_.reset(new Held{Runtime::of(state), luaL_ref(state, LUA_REGISTRYINDEX), std::move(place)});
}

void Callback::push(lua_State* state) const { lua_rawgeti(state, LUA_REGISTRYINDEX, held_->reference); }
Runtime& Callback::runtime() const { return held_->runtime; }
const std::string& Callback::place() const { return held_->place; }

void Callback::call(const std::function<int(lua_State*)>& push_arguments,
                    const std::function<void(lua_State*)>& take) const {
  const std::shared_ptr<Held> alive = held_;  // the script may drop this callback while it runs
  const auto placed = [&](const char* message) {
    return ScriptError(alive->place.empty() ? message : text(alive->place, ": ", message));
  };
  try {
    alive->runtime.run([&](lua_State* state) {
      lua_rawgeti(state, LUA_REGISTRYINDEX, alive->reference);
      const int arguments = push_arguments ? push_arguments(state) : 0;
      lua_call(state, arguments, take ? 1 : 0);
      if (!take) return;
      try {
        take(state);
      } catch (const Error& error) { throw placed(error.what()); }
    });
  } catch (const Interrupted&) { throw; } catch (const ScriptError& error) {
    if (names_place(error.what())) throw;
    throw placed(error.what());  // of a function of ours, which has no lines
  }
}

double Callback::number(const std::string& what) const {
  double value = 0.0;
  call({}, [&](lua_State* state) { value = check_number(state, -1, what, "what the function returns", ""); });
  return value;
}

Vec3 Callback::vector(double time, const std::string& what) const {
  Vec3 value = zero3();
  call(
      [&](lua_State* state) {
        lua_pushnumber(state, time);
        return 1;
      },
      [&](lua_State* state) { value = check_vec(state, -1, what, "what the function returns", "m"); });
  return value;
}

}  // namespace pantin::lua
