#pragma once
// What a script has in Lua's memory, written and made anew: tables, functions with their locals, things, laws. A function is
// named by where it is in the script's text; what the sandbox begins with is named by how a script gets to it.
#include <lua.hpp>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lua/law/force.hpp"
#include "lua/thing/script.hpp"
#include "snapshot/world_state.hpp"

namespace pantin::lua {

/// Remembers what the sandbox begins with; call before the script runs.
void note_permanents(lua_State* state);

/// Values are written where they are first met; what is in them when `contents` is called.
class HeapWriter {
 public:
  HeapWriter(lua_State* state, Script& script, Writer& to);
  ~HeapWriter() { lua_settop(state_, base_); }
  HeapWriter(const HeapWriter&) = delete;
  HeapWriter& operator=(const HeapWriter&) = delete;

  /// The value at an index; `what` is what messages call it. Throws Error where it cannot be kept.
  void value(int index, const std::string& what);
  void function(const Callback& callback);
  /// What is in the permanent tables, and in all that was met.
  void contents();
  /// Whether the object at an index was met.
  bool has(int index);

 private:
  void object(int index, const std::string& what);
  void described(int index, const std::string& what);
  void closure(int index, const std::string& what);
  void userdata(int index, const std::string& what);
  void ref(int index, const std::string& what);
  void permanent_tables();
  void table(int index, const std::string& what);
  void upvalues(int index, const std::string& what, bool shared);
  void number(std::uint64_t n) { to_.raw(&n, sizeof n); }

  lua_State* state_;
  Script& script_;
  Writer& to_;
  int base_, seen_, list_, permanents_;  ///< stack: height before; number by object; object by number; name by object
  lua_Integer count_ = 0;
  std::vector<std::string> names_;                                                       ///< (objects) for messages
  std::unordered_map<std::string, std::pair<std::uint32_t, std::uint32_t>> prototypes_;  ///< chunk, number in it
  std::unordered_map<const void*, std::string> built_in_;                                ///< names by address
  std::unordered_map<const void*, std::pair<lua_Integer, int>> upvalues_;                ///< whose, and which
};

class HeapReader {
 public:
  HeapReader(lua_State* state, Script& script, Reader& from);
  ~HeapReader() { lua_settop(state_, base_); }
  HeapReader(const HeapReader&) = delete;
  HeapReader& operator=(const HeapReader&) = delete;

  /// Pushes the next value.
  void value();
  Callback function();
  void contents();
  /// Calls use(spec) for all laws that were read.
  template <class Use>
  void each_law(Use use) {
    for (lua_Integer i = 1; i <= count_; i++) {
      lua_rawgeti(state_, list_, i);
      if (LawSpec* spec = to_law(state_, -1)) use(*spec);
      lua_pop(state_, 1);
    }
  }

 private:
  void remember();
  void closure();
  void userdata(std::uint8_t mark);
  void permanent_tables();
  void table(int index);
  void upvalues(int index, bool shared);
  std::uint64_t number();
  std::string text();

  lua_State* state_;
  Script& script_;
  Reader& from_;
  int base_, list_, permanents_;  ///< stack: height before; object by number; object by name
  lua_Integer count_ = 0;
  std::vector<std::vector<std::string>> prototypes_;
};

/// Laws as values, and functions of laws; in kept_functions.cpp.
void visit_spec(HeapWriter& heap, Writer& to, LawSpec& spec);
void visit_spec(HeapReader& heap, Reader& from, LawSpec& spec);

}  // namespace pantin::lua
