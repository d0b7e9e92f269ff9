#include "lua/thing/kept_tables.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "base/interruptible.hpp"
#include "lua/thing/handles.hpp"
#include "lua/thing/law_parameters.hpp"
#include "lua/value/copies.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr int deepest = 150;  // tables in tables of scene.store

bool is_plain(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
    case LUA_TSTRING:
    case LUA_TBOOLEAN: return true;
    case LUA_TTABLE: return is_locked(state, index) || thing_of_parameters(state, index);
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

/// A table without a metatable, whose contents are kept.
bool is_open(lua_State* state, int index) {
  if (!lua_istable(state, index)) return false;
  if (!lua_getmetatable(state, index)) return true;
  lua_pop(state, 1);
  return false;
}

bool may_be_kept(lua_State* state, int key, int value) {
  return is_plain(state, key) && (is_open(state, value) || is_plain(state, value));
}

/// Tells what is not plain in a table and in those in it, the nearest first, and otherwise in the order of their paths: that of
/// lua_next differs from run to run.
class PlainCheck {
 public:
  explicit PlainCheck(lua_State* state) : state_(state) {
    lua_newtable(state);
    list_ = lua_gettop(state);
  }
  /// Throws Error. `path` is what messages call the table at stack index `root`.
  void look(int root, const std::string& path) {
    lua_pushvalue(state_, root);
    add(path, 0);
    for (; !waiting_.empty(); waiting_.pop_front()) {
      lua_rawgeti(state_, list_, waiting_.front().place);
      lua_pushvalue(state_, -1);
      const bool seen = lua_rawget(state_, list_) != LUA_TNIL;
      lua_pop(state_, 1);
      if (!seen) look_into(waiting_.front());
      lua_pop(state_, 1);
    }
  }

 private:
  struct Waiting {
    std::string path;
    int depth;
    lua_Integer place;  ///< in the list
  };

  /// The table at the top, which it pops.
  void add(std::string path, int depth) {
    lua_rawseti(state_, list_, ++listed_);
    waiting_.push_back({std::move(path), depth, listed_});
  }
  /// The table at the top, which stays.
  void look_into(const Waiting& of) {
    require(of.depth < deepest, of.path, ": tables are nested more than ", deepest, " deep");
    const int table = lua_gettop(state_), key = table + 1, value = table + 2;
    lua_pushvalue(state_, table);
    lua_pushboolean(state_, 1);
    lua_rawset(state_, list_);
    std::string wrong;
    const std::size_t first = waiting_.size();
    for (lua_pushnil(state_); lua_next(state_, table); lua_settop(state_, key)) {
      loop_.count();
      std::string step = is_plain(state_, key) ? step_of_path(state_, key) : text(": a key");
      if (!may_be_kept(state_, key, value)) {
        std::string told = text(of.path, step, " is ",
                                !is_plain(state_, key)       ? kind_of_value(state_, key)
                                : lua_istable(state_, value) ? "a table with a metatable"
                                                             : kind_of_value(state_, value));
        if (wrong.empty() || told < wrong) wrong = std::move(told);
      } else if (is_open(state_, value)) {
        add(of.path + step, of.depth + 1);
      }
    }
    require(
        wrong.empty(), wrong,
        ", and only plain values can be kept: numbers, strings, true and false, vecs, quats, things of the scene and "
        "tables of these");
    std::sort(waiting_.begin() + static_cast<std::ptrdiff_t>(first), waiting_.end(),
              [this](const Waiting& a, const Waiting& b) {
                loop_.count();
                return a.path < b.path;
              });
  }

  lua_State* state_;
  int list_;  ///< stack index of the tables found so far, and of those that were looked into as keys
  lua_Integer listed_ = 0;
  std::deque<Waiting> waiting_;
  Interruptible loop_;
};

/// Goes through a table and those in it, the nearest first. `kept`: stack index of the table from each table to a copy of
/// its contents.
class Keeper {
 public:
  Keeper(lua_State* state, int kept, bool plain) : state_(state), kept_(kept), plain_(plain) {
    lua_newtable(state);
    list_ = lua_gettop(state);
  }

  /// The table at stack index `root`. False where it has to be plain and is not.
  bool keep(int root) {
    lua_pushvalue(state_, root);
    add(0);
    for (lua_Integer i = 1; is_plain_ && !depths_.empty(); i++) {
      lua_rawgeti(state_, list_, i);
      copy(depths_.front());
      depths_.pop_front();
    }
    return is_plain_;
  }

 private:
  /// The table at the top, which it pops, comes into the list where it is new.
  void add(int depth) {
    const int table = lua_gettop(state_);
    lua_pushvalue(state_, table);
    if (lua_rawget(state_, kept_) != LUA_TNIL) return lua_settop(state_, table - 1);
    if (plain_ && depth >= deepest) is_plain_ = false;
    lua_pushvalue(state_, table);
    lua_newtable(state_);
    lua_rawset(state_, kept_);
    lua_pushvalue(state_, table);
    lua_rawseti(state_, list_, ++listed_);
    depths_.push_back(depth);
    lua_settop(state_, table - 1);
  }
  /// The contents of the table at the top, which it pops.
  void copy(int depth) {
    const int table = lua_gettop(state_), key = table + 2, value = table + 3;
    loop_.count();
    lua_pushvalue(state_, table);
    lua_rawget(state_, kept_);
    lua_pushnil(state_);
    while (lua_next(state_, table)) {
      loop_.count();
      if (plain_ && !may_be_kept(state_, key, value)) is_plain_ = false;
      if (is_open(state_, value)) {
        lua_pushvalue(state_, value);
        add(depth + 1);
      }
      lua_pushvalue(state_, key);
      lua_insert(state_, value);
      lua_rawset(state_, table + 1);
    }
    lua_settop(state_, table - 1);
  }

  lua_State* state_;
  int kept_;
  bool plain_, is_plain_ = true;
  int list_;  ///< stack index of the tables found so far
  lua_Integer listed_ = 0;
  std::deque<int> depths_;  ///< of those of them that are still to be copied
  Interruptible loop_;
};

void keep_table(lua_State* state, int index, int reference, const std::string& name, bool plain) {
  const int table = lua_absindex(state, index), top = lua_gettop(state);
  luaL_checkstack(state, 16, nullptr);
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
  if (!Keeper(state, lua_gettop(state), plain).keep(table)) PlainCheck(state).look(table, name);
  lua_settop(state, top);
}

/// Makes the table at `to` hold what that at `from` holds.
void fill(lua_State* state, int to, int from, Interruptible& loop) {
  lua_pushnil(state);
  while (lua_next(state, to)) {
    loop.count();
    lua_pop(state, 1);
    lua_pushvalue(state, -1);
    lua_pushnil(state);
    lua_rawset(state, to);
  }
  lua_pushnil(state);
  while (lua_next(state, from)) {
    loop.count();
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
  Interruptible loop;
  luaL_checkstack(state, 8, nullptr);
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference_);
  const int kept = lua_gettop(state);
  for (lua_pushnil(state); lua_next(state, kept); lua_pop(state, 1)) {
    loop.count();
    fill(state, kept + 1, kept + 2, loop);
  }
  lua_pop(state, 1);
}

}  // namespace pantin::lua
