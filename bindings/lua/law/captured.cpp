#include "lua/law/captured.hpp"

#include <bit>
#include <set>

#include "lua/value/values.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = (a ^ (b + 0x9e3779b97f4a7c15ULL)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

class CapturedReader {
 public:
  explicit CapturedReader(lua_State* state) : state_(state) {}

  bool saw_all() const { return count_ <= most; }

  /// Of the value at the top.
  std::uint64_t value() {
    const auto kind = static_cast<std::uint64_t>(lua_type(state_, -1));
    switch (lua_type(state_, -1)) {
      case LUA_TNUMBER: return mixed(kind, bits(lua_tonumber(state_, -1)));
      case LUA_TBOOLEAN: return mixed(kind, lua_toboolean(state_, -1) != 0 ? 1 : 0);
      case LUA_TUSERDATA:
        if (const auto v = to_vec(state_, -1)) return mixed(mixed(bits((*v)[0]), bits((*v)[1])), bits((*v)[2]));
        return mixed(kind, address());
      case LUA_TFUNCTION: return is_new() ? mixed(address(), of_function()) : address();
      case LUA_TTABLE: return is_new() ? mixed(address(), of_table()) : address();
      default: return mixed(kind, address());
    }
  }

 private:
  static constexpr int most = 1000, room = 8;

  std::uint64_t address() const { return reinterpret_cast<std::uintptr_t>(lua_topointer(state_, -1)); }
  bool is_new() {
    return count_ <= most && lua_checkstack(state_, room) && known_.insert(lua_topointer(state_, -1)).second;
  }

  std::uint64_t of_function() {
    std::uint64_t all = 0;
    for (int i = 1; lua_getupvalue(state_, -1, i) != nullptr; i++) {
      all = mixed(all, value());
      lua_pop(state_, 1);
    }
    return all;
  }

  /// The order of a table is not told.
  std::uint64_t of_table() {
    std::uint64_t all = 0;
    if (lua_getmetatable(state_, -1) != 0) {
      all = value();
      lua_pop(state_, 1);
    }
    lua_pushnil(state_);
    while (lua_next(state_, -2) != 0) {
      if (++count_ > most) {
        lua_pop(state_, 2);
        break;
      }
      const std::uint64_t held = value();
      lua_pop(state_, 1);
      const std::uint64_t key = lua_type(state_, -1) == LUA_TNUMBER ? bits(lua_tonumber(state_, -1)) : address();
      all += mixed(key, held);
    }
    return all;
  }

  lua_State* state_;
  std::set<const void*> known_;
  int count_ = 0;
};

}  // namespace

std::optional<std::uint64_t> captured_values(const Callback& function) {
  lua_State* state = function.runtime().active();
  if (!lua_checkstack(state, 8)) return {};
  function.push(state);
  CapturedReader reader(state);
  const std::uint64_t all = reader.value();
  lua_pop(state, 1);
  if (!reader.saw_all()) return {};
  return all;
}

}  // namespace pantin::lua
