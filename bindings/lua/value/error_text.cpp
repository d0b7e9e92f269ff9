#include "lua/value/error_text.hpp"

#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "base/interruptible.hpp"
#include "lua/value/tostring.hpp"
#include "lua/value/values.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t most_shown = 8;

/// A text in quotes, a number or a truth value as it is, of all else the kind.
std::string brief(lua_State* state, int index, bool quoted) {
  const int type = lua_type(state, index);
  if (type == LUA_TSTRING && quoted)
    return text("\"", std::string_view(lua_tostring(state, index), lua_rawlen(state, index)), "\"");
  if (type != LUA_TSTRING && type != LUA_TNUMBER && type != LUA_TBOOLEAN) return kind_of_value(state, index);
  lua_pushvalue(state, index);
  const std::string shown(push_text(state, -1));
  lua_pop(state, 2);
  return shown;
}

/// "{ code = 3, reason = "full" }"
std::string table_text(lua_State* state, int index) {
  std::multiset<std::pair<std::string, std::string>> fields;  // the order of lua_next differs from run to run
  Interruptible loop;
  bool more = false;
  lua_pushnil(state);
  while (lua_next(state, index)) {
    const bool named = lua_type(state, -2) == LUA_TSTRING;
    std::string key = brief(state, lua_absindex(state, -2), false);
    if (!named) key = text("[", key, "]");
    loop.count_bytes(key.size());
    if (fields.size() < most_shown || key <= std::prev(fields.end())->first) {
      std::string value = brief(state, lua_absindex(state, -1), true);
      loop.count_bytes(value.size());
      fields.emplace(std::move(key), std::move(value));
    } else {
      more = true;
    }
    lua_pop(state, 1);
    if (fields.size() <= most_shown) continue;
    fields.erase(std::prev(fields.end()));
    more = true;
  }
  std::string all;
  for (const auto& [key, value] : fields) all += text(all.empty() ? "" : ", ", key, " = ", value);
  if (more) all += ", …";
  return all.empty() ? "{}" : text("{ ", all, " }");
}

std::string error_text(lua_State* state, int index) {
  if (lua_isnil(state, index)) return "error without a message";
  const bool own_text = luaL_getmetafield(state, index, "__tostring") != LUA_TNIL;
  if (own_text) lua_pop(state, 1);
  if (own_text || !lua_istable(state, index)) return text("error: ", push_text(state, index));
  return text("error: ", table_text(state, index));
}

constexpr const char* loop_advice =
    "; a loop counts with plain numbers: write math.floor(x), or give the law as a tension or force, which gets plain "
    "numbers";

/// What Lua's own messages leave open.
const char* advice(const std::string& message) {
  const auto says = [&](const char* part) { return message.find(part) != std::string::npos; };
  return says("'for'") && says(number_with_derivative) && !says(loop_advice) ? loop_advice : "";
}

int describe(lua_State* state) {
  luaL_checkstack(state, 16, nullptr);
  const std::string message = error_message(state, 1, where(state));
  lua_pushlstring(state, message.data(), message.size());
  return 1;
}

}  // namespace

std::string error_message(lua_State* state, int index, const std::string& place) {
  std::string message;
  if (lua_type(state, index) == LUA_TSTRING) {
    std::size_t size = 0;
    const char* s = lua_tolstring(state, index, &size);
    message.assign(s, size);
    if (message == Runtime::of(state).usage_message) return message;
    message += advice(message);
  } else {
    message = error_text(state, index);
  }
  return place.empty() || names_place(message) ? message : text(place, ": ", message);
}

int describe_error(lua_State* state) { return guard<describe>(state); }

}  // namespace pantin::lua
