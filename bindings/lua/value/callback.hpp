#pragma once
#include <functional>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/lanes.hpp"
#include "model/group.hpp"

namespace pantin::lua {

class Runtime;

/// A function of a script, kept alive. Calls run protected and within the limits; errors leave as ScriptError.
class Callback {
 public:
  Callback(lua_State* state, int index);

  /// Calls with the values that `push(state)` pushes (it returns how many); `take(state)` reads the one result at -1.
  void call(const std::function<int(lua_State*)>& push = {}, const std::function<void(lua_State*)>& take = {}) const;
  /// A finite number.
  double number(const std::string& what) const;
  /// A finite vec of the time [s].
  Vec3 vector(double time, const std::string& what) const;
  /// "scene.lua:12": where the function begins.
  const std::string& place() const;
  void push(lua_State* state) const;
  Runtime& runtime() const;

 private:
  struct Held;
  std::shared_ptr<Held> held_;
};

}  // namespace pantin::lua
