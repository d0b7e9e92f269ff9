// Scripts that wait: each is a coroutine, which the choreography takes on from wait to wait.
#include <memory>
#include <utility>

#include "lua/scene/choreography.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/value/arguments.hpp"
#include "lua/value/error_text.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/interrupt.hpp"

namespace pantin::lua {
namespace {

/// Upvalue 1: the coroutine that may wait.
int check_wait(lua_State* state) {
  require(lua_tothread(state, lua_upvalueindex(1)) == state,
          "wait: it belongs to the play that was given it, and not to another coroutine or to a callback");
  lua_settop(state, 1);
  if (lua_isnoneornil(state, 1)) {
    lua_settop(state, 0);
    lua_pushnumber(state, 0.0);
  }
  if (lua_isfunction(state, 1)) return 0;
  const double seconds = check_number(state, 1, "wait", "argument 1", "s");
  require(seconds >= 0.0, "wait: argument 1 must be >= 0 s or a function, got ", seconds);
  return 0;
}

const char by_wait = 0;  // its address marks what `wait` yields

int wait(lua_State* state) {
  guard<check_wait>(state);
  lua_pushlightuserdata(state, const_cast<char*>(&by_wait));
  return lua_yield(state, 2);
}

class Coroutine {
 public:
  Coroutine(lua_State* state, int index, Script& script, AnyId target)
      : script_(script), position_(Callback(state, index).place()), thread_(lua_newthread(state)) {
    lua_pushvalue(state, index);
    lua_xmove(state, thread_, 1);
    lua_pushvalue(state, -1);
    lua_pushcclosure(state, wait, 1);
    lua_xmove(state, thread_, 1);
    arguments_ = 1;
    if (!std::holds_alternative<std::monostate>(target)) {
      push_thing(thread_, script, target);
      arguments_ = 2;
    }
    reference_ = luaL_ref(state, LUA_REGISTRYINDEX);
  }
  ~Coroutine() { luaL_unref(script_.runtime.active(), LUA_REGISTRYINDEX, reference_); }
  Coroutine(const Coroutine&) = delete;
  Coroutine& operator=(const Coroutine&) = delete;

  std::optional<Wait> go() {
    std::optional<Wait> found;
    noting_stale(script_.runtime, [&] { script_.runtime.run([&](lua_State* state) { found = resume(state); }); });
    return found;
  }

 private:
  std::optional<Wait> resume(lua_State* state) {
    int results = 0;
    int status = LUA_OK;
    {
      const Switched switched(script_.runtime.watch(), thread_);
      status = lua_resume(thread_, state, std::exchange(arguments_, 0), &results);
    }
    if (status == LUA_OK) return {};
    if (status != LUA_YIELD) return fail(state), std::nullopt;
    require(results == 2 && lua_touserdata(thread_, -1) == &by_wait, position_,
            ": play: it waits by wait(…), not by coroutine.yield");
    Wait wanted;
    if (lua_isfunction(thread_, -2)) {
      const Callback until(thread_, lua_gettop(thread_) - 1);
      wanted.until = [until] {
        bool holds = false;
        noting_stale(until.runtime(),
                     [&] { until.call({}, [&](lua_State* s) { holds = lua_toboolean(s, -1) != 0; }); });
        return holds;
      };
    } else {
      wanted.delay = lua_tonumber(thread_, -2);
    }
    lua_pop(thread_, results);
    return wanted;
  }

  /// Raises the coroutine's error on the state that resumed it.
  void fail(lua_State* state) {
    const std::string place = where(thread_);
    lua_xmove(thread_, state, 1);
    std::string message = error_message(state, lua_gettop(state), place.empty() ? position_ : place);
    if (script_.runtime.watch().over && !scripts_interrupted()) message += "; does this play ever wait?";
    lua_pushlstring(state, message.data(), message.size());
    lua_error(state);
  }

  Script& script_;
  std::string position_;
  lua_State* thread_;
  int arguments_ = 0;  // waiting on the coroutine's stack for its first start
  int reference_ = LUA_NOREF;
};

}  // namespace

std::function<std::optional<Wait>()> play_of(lua_State* state, int index, Script& script, AnyId target) {
  const auto coroutine = std::make_shared<Coroutine>(state, index, script, target);
  return [coroutine] { return coroutine->go(); };
}

}  // namespace pantin::lua
