#pragma once
// Short scenes for the tests of the Lua bindings.
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <string>

#include "lua/scene/open.hpp"
#include "scene/scene.hpp"
#include "support/sources.hpp"

namespace pantin::lua_tests {

inline SceneOptions options(std::map<std::string, std::string> set = {}) {
  SceneOptions o;
  o.set = std::move(set);
  o.script_limit = 0.2;
  o.memory_limit = std::size_t{16} << 20;
  o.home = sources::folder();
  return o;
}

inline std::unique_ptr<Scene> open(const std::string& source, std::map<std::string, std::string> set = {}) {
  return lua::open_scene_text(source, "scene.lua", "", options(std::move(set)));
}

/// The message of a scene that must fail, while it is built or in one of its first steps; empty where it does not.
inline std::string failure(const std::string& source, std::map<std::string, std::string> set = {}) {
  try {
    const auto scene = open(source, std::move(set));
    for (int i = 0; i < 10; i++) scene->step();
  } catch (const Error& error) { return error.what(); }
  return "";
}

/// What the scene's `scene:result("x", …)` says.
inline SceneValue result(const std::string& source) { return open(source)->results().at("x"); }
inline double number(const std::string& source) { return std::get<double>(result(source)); }
inline std::string word(const std::string& source) { return std::get<std::string>(result(source)); }

}  // namespace pantin::lua_tests
