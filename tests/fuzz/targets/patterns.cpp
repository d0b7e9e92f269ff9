// A pattern up to the first zero byte, and a subject behind it: found, captured and replaced as Lua's own library does.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <lua.hpp>
#include <string>

#include "base/check.hpp"
#include "lua/scene/open.hpp"
#include "scene/scene.hpp"

using namespace pantin;

namespace {

constexpr const char* ask = R"(
  local function told(ok, ...)
    if not ok then return "error" end
    local all = table.pack(...)
    for i = 1, all.n do all[i] = tostring(all[i]) end
    return table.concat(all, "\1")
  end
  return told(pcall(string.find, subject, pattern)) .. "\2" .. told(pcall(string.gsub, subject, pattern, "<%0>"))
)";

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\%03d", static_cast<int>(static_cast<unsigned char>(c)));
    all += escape;
  }
  return all + "\"";
}

std::string by_lua(const std::string& head) {
  lua_State* const state = luaL_newstate();
  luaL_openlibs(state);
  std::string said;
  if (luaL_dostring(state, (head + ask).c_str()) == LUA_OK) {
    std::size_t length = 0;
    const char* const text = lua_tolstring(state, -1, &length);
    said.assign(text, length);
  }
  lua_close(state);
  return said;
}

std::string by_scene(const std::string& head) {
  const std::string script = head + "local function ask() " + ask + " end scene:result('said', ask())";
  return std::get<std::string>(lua::open_scene_text(script, "scene.lua", ".", {})->results().at("said"));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(all.find('\0'), all.size());
  const std::string pattern = all.substr(0, end), subject = end < size ? all.substr(end + 1) : "";
  // Lua's own cannot be stopped.
  const auto repeats = [](char c) { return c == '*' || c == '+' || c == '-' || c == '?'; };
  if (subject.size() > 60 || pattern.size() > 60 || std::count_if(pattern.begin(), pattern.end(), repeats) > 4)
    return 0;
  const std::string head = "local pattern, subject = " + quoted(pattern) + ", " + quoted(subject) + "\n";
  try {
    if (by_lua(head) != by_scene(head)) std::abort();
  } catch (const Error&) { std::abort(); }
  return 0;
}
