#include "lua/thing/kept_tables.hpp"

#include <deque>

#include "lua/thing/handles.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr int deepest = 150;  // tables in tables of scene.store

bool is_plain(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
    case LUA_TSTRING:
    case LUA_TBOOLEAN: return true;
    case LUA_TUSERDATA: break;
    default: return false;
  }
  const Ref* ref = to_ref(state, index);
  if (!ref) return to_vec(state, index) || to_quat(state, index);
  return ref->kind == Kind::hand || !std::holds_alternative<std::monostate>(ref->thing);
}

std::string step_of_path(lua_State* state, int key) {
  if (lua_type(state, key) == LUA_TSTRING) return text(".", lua_tostring(state, key));
  if (lua_isinteger(state, key)) return text("[", lua_tointeger(state, key), "]");
  if (lua_isnumber(state, key)) return text("[", lua_tonumber(state, key), "]");
  const Ref* ref = to_ref(state, key);
  return text("[", ref ? describe(*ref) : std::string(kind_of_value(state, key)), "]");
}

/// Goes through a table and those in it, the nearest first. `kept`: stack index of the table from each table to a copy of
/// its contents.
class Keeper {
 public:
  Keeper(lua_State* state, int kept, bool plain) : state_(state), kept_(kept), plain_(plain) {
    lua_newtable(state);
    list_ = lua_gettop(state);
  }

  /// The table at stack index `root`. `path` is what messages call it.
  void keep(int root, const std::string& path) {
    lua_pushvalue(state_, root);
    add(path, 0);
    for (lua_Integer i = 1; !waiting_.empty(); i++) {
      lua_rawgeti(state_, list_, i);
      copy(waiting_.front());
      waiting_.pop_front();
    }
  }

 private:
  struct Waiting {
    std::string path;
    int depth;
  };

  /// The table at the top, which it pops, comes into the list where it is new.
  void add(const std::string& path, int depth) {
    const int table = lua_gettop(state_);
    lua_pushvalue(state_, table);
    if (lua_rawget(state_, kept_) != LUA_TNIL) return lua_settop(state_, table - 1);
    require(!plain_ || depth < deepest, path, ": tables are nested more than ", deepest, " deep");
    lua_pushvalue(state_, table);
    lua_newtable(state_);
    lua_rawset(state_, kept_);
    lua_pushvalue(state_, table);
    lua_rawseti(state_, list_, ++listed_);
    waiting_.push_back({path, depth});
    lua_settop(state_, table - 1);
  }
  /// The contents of the table at the top, which it pops.
  void copy(const Waiting& of) {
    const int table = lua_gettop(state_);
    lua_pushvalue(state_, table);
    lua_rawget(state_, kept_);
    lua_pushnil(state_);
    while (lua_next(state_, table)) {
      take(of.path, of.depth);
      lua_pushvalue(state_, -2);
      lua_insert(state_, -2);
      lua_rawset(state_, table + 1);
    }
    lua_settop(state_, table - 1);
  }
  /// Key and value at the top, which stay.
  void take(const std::string& path, int depth) {
    const int value = lua_gettop(state_), key = value - 1;
    const bool open = lua_istable(state_, value) && !has_metatable(value);
    if (plain_) {
      require(is_plain(state_, key), path, ": a key is ", kind_of_value(state_, key), only);
      require(open || is_plain(state_, value), path, step_of_path(state_, key), " is ",
              lua_istable(state_, value) ? "a table with a metatable" : kind_of_value(state_, value), only);
    }
    if (!open) return;
    lua_pushvalue(state_, value);
    add(plain_ ? path + step_of_path(state_, key) : path, depth + 1);
  }
  bool has_metatable(int index) {
    if (!lua_getmetatable(state_, index)) return false;
    lua_pop(state_, 1);
    return true;
  }

  static constexpr const char* only =
      ", and only plain values can be kept: numbers, strings, true and false, vecs, quats, things of the scene and "
      "tables of these";
  lua_State* state_;
  int kept_;
  bool plain_;
  int list_;  ///< stack index of the tables found so far
  lua_Integer listed_ = 0;
  std::deque<Waiting> waiting_;  ///< those of them that are still to be copied
};

void keep_table(lua_State* state, int index, int reference, const std::string& name, bool plain) {
  const int table = lua_absindex(state, index);
  luaL_checkstack(state, 16, nullptr);
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
  Keeper keeper(state, lua_gettop(state), plain);
  keeper.keep(table, name);
  lua_pop(state, 2);
}

/// Makes the table at `to` hold what that at `from` holds.
void fill(lua_State* state, int to, int from) {
  lua_pushnil(state);
  while (lua_next(state, to)) {
    lua_pop(state, 1);
    lua_pushvalue(state, -1);
    lua_pushnil(state);
    lua_rawset(state, to);
  }
  lua_pushnil(state);
  while (lua_next(state, from)) {
    lua_pushvalue(state, -2);
    lua_insert(state, -2);
    lua_rawset(state, to);
  }
}

}  // namespace

KeptTables::KeptTables(lua_State* state) : runtime_(Runtime::of(state)) {
  lua_newtable(state);
  reference_ = luaL_ref(state, LUA_REGISTRYINDEX);
}

KeptTables::~KeptTables() { luaL_unref(runtime_.active(), LUA_REGISTRYINDEX, reference_); }

void KeptTables::keep_plain(lua_State* state, int index, const std::string& name) {
  keep_table(state, index, reference_, name, true);
}

void KeptTables::keep(lua_State* state, int index) { keep_table(state, index, reference_, "data", false); }

void KeptTables::put_back(lua_State* state) const {
  luaL_checkstack(state, 8, nullptr);
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference_);
  const int kept = lua_gettop(state);
  lua_pushnil(state);
  while (lua_next(state, kept)) {
    const int to = lua_gettop(state) - 1;
    fill(state, to, to + 1);
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
}

}  // namespace pantin::lua
