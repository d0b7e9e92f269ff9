#include "lua/carry_tables.hpp"

#include <optional>

#include "lua/handles.hpp"
#include "lua/script.hpp"

namespace pantin::lua {
namespace {

constexpr int deepest = 150;  // tables in tables

/// From the stack of one state to that of another.
class Copier {
 public:
  Copier(lua_State* from, lua_State* to, Script& script, const Counterparts& counterparts)
      : from_(from), to_(to), script_(script), counterparts_(counterparts) {
    lua_newtable(to_);
    copies_ = lua_gettop(to_);
  }

  /// What is in the table at `index` of the old state, into that at the top of the new one.
  void copy_contents(int index, int depth) {
    luaL_checkstack(from_, 6, nullptr);
    luaL_checkstack(to_, 6, nullptr);
    const int table = lua_absindex(from_, index);
    lua_pushnil(from_);
    while (lua_next(from_, table)) {
      if (push(lua_gettop(from_) - 1, depth)) {
        if (push(lua_gettop(from_), depth))
          lua_rawset(to_, -3);
        else
          lua_pop(to_, 1);
      }
      lua_pop(from_, 1);
    }
  }

  std::optional<AnyId> counterpart(const AnyId& id) const {
    const auto found = counterparts_.find(id);
    if (found == counterparts_.end() || !alive(script_.world, found->second)) return {};
    return found->second;
  }

 private:
  /// Pushes a copy of the value at `index`, or nothing and returns false where it is not plain.
  bool push(int index, int depth) {
    switch (lua_type(from_, index)) {
      case LUA_TBOOLEAN: return lua_pushboolean(to_, lua_toboolean(from_, index)), true;
      case LUA_TNUMBER:
        if (lua_isinteger(from_, index))
          lua_pushinteger(to_, lua_tointeger(from_, index));
        else
          lua_pushnumber(to_, lua_tonumber(from_, index));
        return true;
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* text = lua_tolstring(from_, index, &size);
        return lua_pushlstring(to_, text, size), true;
      }
      case LUA_TTABLE: return push_table(index, depth);
      default: return push_value(index);
    }
  }

  bool push_value(int index) {
    if (const auto v = to_vec(from_, index)) return lua::push(to_, *v), true;
    if (const auto q = to_quat(from_, index)) return lua::push(to_, *q), true;
    const Ref* ref = to_ref(from_, index);
    const auto id = ref ? counterpart(any_of(*ref)) : std::nullopt;
    if (id) push_thing(to_, script_, *id);
    return id.has_value();
  }

  bool push_table(int index, int depth) {
    if (depth >= deepest) return false;
    if (lua_getmetatable(from_, index)) return lua_pop(from_, 1), false;
    const void* key = lua_topointer(from_, index);
    if (lua_rawgetp(to_, copies_, key) != LUA_TNIL) return true;
    lua_pop(to_, 1);
    lua_newtable(to_);
    lua_pushvalue(to_, -1);
    lua_rawsetp(to_, copies_, key);
    copy_contents(index, depth + 1);
    return true;
  }

  lua_State *from_, *to_;
  Script& script_;
  const Counterparts& counterparts_;
  int copies_;  // index in `to_`: by address of the old table
};

void carry_data(lua_State* from, lua_State* to, Script& old, Script& fresh, Copier& copier) {
  if (lua_rawgetp(from, LUA_REGISTRYINDEX, &old.keys[kind_count]) == LUA_TTABLE) {
    lua_pushnil(from);
    while (lua_next(from, -2)) {
      const Ref* ref = to_ref(from, -2);
      if (const auto id = copier.counterpart(any_of(*ref))) {
        push_thing(to, fresh, *id);
        push_data(to, *to_ref(to, -1));
        copier.copy_contents(-1, 0);
        lua_pop(to, 2);
      }
      lua_pop(from, 1);
    }
  }
  lua_pop(from, 1);
}

}  // namespace

void carry_tables(Script& old, Script& fresh, const Counterparts& counterparts) {
  old.runtime.run([&](lua_State* from) {
    fresh.runtime.run([&](lua_State* to) {
      Copier copier(from, to, fresh, counterparts);
      push_store(from, old);
      push_store(to, fresh);
      copier.copy_contents(-1, 0);
      lua_pop(from, 1);
      lua_pop(to, 1);
      carry_data(from, to, old, fresh, copier);
      lua_settop(to, 0);
    });
  });
}

}  // namespace pantin::lua
