#pragma once
// Tracing: a law's function is run on symbols, once for each way through its branches, and what it does to them becomes
// an expression.
#include <cstdint>
#include <lua.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lua/law/law_run.hpp"

namespace pantin::lua {

class KeyGuards;

class Trace : public LawRun {
 public:
  Trace(lua_State* state, const LawFunction& function);

  void push(lua_State* state, Seen what, int who) override;
  void push_attribute(lua_State* state, int who, std::size_t index) override;
  void push_parameter(lua_State* state, std::size_t index) override;
  void push_noise(lua_State* state, int index) override;
  bool on_thing(lua_State* state, std::string_view field, bool of_scene) override;

  /// The side that this run takes at a condition, an expression that is 0 or 1.
  bool decide(lua_State* state, Expr condition);
  /// Ends the run: the law cannot be traced. The text gets the line.
  [[noreturn]] void refuse(lua_State* state, const std::string& text);

  /// Begins a run; goes on to the next way through the branches, or returns false after the last.
  void begin_path();
  bool next_path();
  /// The decisions that were made in this run.
  std::vector<std::pair<Expr, bool>> path() const;

  std::uint64_t serial() const { return serial_; }

  Expressions graph;
  std::string refusal;          ///< why it cannot be traced; empty while it can
  KeyGuards* guards = nullptr;  ///< of the run at hand, where it is watched

 private:
  struct Decision {
    Expr condition;
    bool taken;
  };
  std::uint64_t serial_;
  std::vector<Decision> decisions_;
  std::size_t made_ = 0;  ///< decisions of this run
};

struct Traced {
  Expressions graph;
  std::vector<Expr> outputs;  ///< (1), or (3) of a vec; empty: it cannot be traced
  std::string refusal;        ///< "scene.lua:12: …", why not
};

/// Throws Error where the law would be wrong however it is run.
Traced trace(Runtime& runtime, const LawFunction& law);

}  // namespace pantin::lua
