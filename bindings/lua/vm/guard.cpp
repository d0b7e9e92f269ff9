#include "lua/vm/guard.hpp"

#include <new>
#include <string_view>

#include "lua/vm/runtime.hpp"

namespace pantin::lua {

std::string where(lua_State* state) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(state, level, &frame); level++) {
    lua_getinfo(state, "Sl", &frame);
    if (frame.currentline > 0 && std::string_view(frame.source) != own_chunk)
      return std::string(frame.short_src) + ":" + std::to_string(frame.currentline);
  }
  return "";
}

namespace detail {
namespace {

std::string placed(lua_State* state, const char* message) {
  const std::string place = names_place(message) ? "" : where(state);
  return place.empty() ? message : text(place, ": ", message);
}

}  // namespace

// The error is raised after the catch block: an exception that is being handled must not be left by another.
int guarded(lua_State* state, lua_CFunction function) {
  std::string message;
  Runtime& runtime = Runtime::of(state);
  try {
    return function(state);
  } catch (const ScriptError& error) { message = error.what(); } catch (const UsageError& error) {
    message = runtime.usage_message = error.what();
  } catch (const StaleHandle& error) {
    message = runtime.stale_message = placed(state, error.what());
  } catch (const GivenUp&) { message = why_stopped(state); } catch (const std::bad_alloc&) {
    message = placed(state, "the computer has no memory left for this");
  } catch (const std::exception& error) {
    message =
        runtime.watch().over ? why_stopped(state) : placed(state, error.what());  // also of what became of GivenUp
  }
  lua_pushlstring(state, message.data(), message.size());
  return lua_error(state);
}

}  // namespace detail
}  // namespace pantin::lua
