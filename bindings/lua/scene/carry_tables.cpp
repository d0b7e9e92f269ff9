#include "lua/scene/carry_tables.hpp"

#include <optional>

#include "lua/scene/scene_type.hpp"
#include "lua/thing/handles.hpp"
#include "lua/thing/law_parameters.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/copies.hpp"

namespace pantin::lua {
namespace {

/// From tables of one state to tables of another, and to copies of all that are in them.
class Copier {
 public:
  Copier(lua_State* from, lua_State* to, Script& script, const Counterparts& counterparts)
      : from_(from), to_(to), script_(script), counterparts_(counterparts) {
    lua_newtable(from_);
    waiting_from_ = lua_gettop(from_);
    lua_newtable(to_);
    waiting_to_ = lua_gettop(to_);
    lua_newtable(to_);
    copies_ = lua_gettop(to_);
  }

  /// What is in the table at the top of the old stack comes into that at the top of the new one; pops both.
  void add() {
    lua_pushvalue(to_, -1);
    lua_rawsetp(to_, copies_, lua_topointer(from_, -1));
    lua_rawseti(from_, waiting_from_, ++added_);
    lua_rawseti(to_, waiting_to_, added_);
  }

  /// The nearest first, however deep they are.
  void copy() {
    for (lua_Integer i = 1; i <= added_; i++) {
      lua_rawgeti(from_, waiting_from_, i);
      lua_rawgeti(to_, waiting_to_, i);
      copy_contents();
      lua_pop(from_, 1);
      lua_pop(to_, 1);
    }
  }

  std::optional<AnyId> counterpart(const AnyId& id) const {
    const auto found = counterparts_.find(id);
    if (found == counterparts_.end() || !alive(script_.world, found->second)) return {};
    return found->second;
  }

 private:
  void copy_contents() {
    lua_pushnil(from_);
    while (lua_next(from_, -2)) {
      if (push(lua_gettop(from_) - 1)) {
        if (push(lua_gettop(from_)))
          lua_rawset(to_, -3);
        else
          lua_pop(to_, 1);
      }
      lua_pop(from_, 1);
    }
  }

  /// Pushes a copy of the value at `index`, or nothing and returns false where it is not plain.
  bool push(int index) {
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
      case LUA_TTABLE: return push_table(index);
      default: return push_value(index);
    }
  }

  bool push_value(int index) {
    if (const auto v = to_vec(from_, index)) return lua::push(to_, *v), true;
    if (const auto q = to_quat(from_, index)) return lua::push(to_, *q), true;
    const Ref* ref = to_ref(from_, index);
    const auto id = ref ? counterpart(ref->thing) : std::nullopt;
    if (id) push_thing(to_, script_, *id);
    return id.has_value();
  }

  void push_locked(int index) {
    const std::string message = message_of_locked(from_, index);
    lua_pushvalue(from_, index);
    unlock(from_, lua_gettop(from_));
    lua_newtable(to_);
    copy_contents();
    lua_pop(from_, 1);
    lock(to_, message);
  }

  bool push_parameters(const Ref& of) {
    const auto id = counterpart(of.thing);
    if (!id) return false;
    push_thing(to_, script_, *id);
    push_law_parameters(to_, *to_ref(to_, -1));
    lua_remove(to_, -2);
    return true;
  }

  bool push_table(int index) {
    if (is_locked(from_, index)) return push_locked(index), true;
    if (const Ref* thing = thing_of_parameters(from_, index)) return push_parameters(*thing);
    if (lua_getmetatable(from_, index)) return lua_pop(from_, 1), false;
    if (lua_rawgetp(to_, copies_, lua_topointer(from_, index)) != LUA_TNIL) return true;
    lua_pop(to_, 1);
    lua_newtable(to_);
    lua_pushvalue(to_, -1);
    lua_pushvalue(from_, index);
    add();
    return true;
  }

  lua_State *from_, *to_;
  Script& script_;
  const Counterparts& counterparts_;
  int waiting_from_, waiting_to_;  ///< indices of lists of tables
  int copies_;                     ///< index in `to_`: by address of the old table
  lua_Integer added_ = 0;
};

void add_data(lua_State* from, lua_State* to, Script& old, Script& fresh, Copier& copier) {
  if (lua_rawgetp(from, LUA_REGISTRYINDEX, &old.keys[kind_count]) == LUA_TTABLE) {
    lua_pushnil(from);
    while (lua_next(from, -2)) {
      const Ref* ref = to_ref(from, -2);
      if (const auto id = copier.counterpart(ref->thing)) {
        push_thing(to, fresh, *id);
        push_data(to, *to_ref(to, -1));
        copier.add();
        lua_pop(to, 1);
      } else {
        lua_pop(from, 1);
      }
    }
  }
  lua_pop(from, 1);
}

}  // namespace

void carry_tables(Script& old, Script& fresh, const Counterparts& counterparts) {
  old.runtime.run([&](lua_State* from) {
    fresh.runtime.run([&](lua_State* to) {
      luaL_checkstack(from, 16, nullptr);
      luaL_checkstack(to, 16, nullptr);
      Copier copier(from, to, fresh, counterparts);
      push_store(from, old);
      push_store(to, fresh);
      copier.add();
      add_data(from, to, old, fresh, copier);
      copier.copy();
      lua_settop(from, 0);
      lua_settop(to, 0);
    });
  });
}

}  // namespace pantin::lua
