// The part of Lua's string library that is made anew: what may take long asks the clock, and no address comes out.
#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

#include "lua/library/patterns.hpp"
#include "lua/library/sandbox.hpp"
#include "lua/value/tostring.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/watchdog.hpp"

namespace pantin::lua {
namespace {

std::string_view check_string(lua_State* state, int index) {
  std::size_t size = 0;
  const char* s = luaL_checklstring(state, index, &size);
  return {s, size};
}

/// The place, from 0, that argument `index` means: from 1, or from the end where it is negative.
std::size_t check_start(lua_State* state, int index, std::size_t size) {
  const lua_Integer i = luaL_optinteger(state, index, 1), length = static_cast<lua_Integer>(size);
  if (i > 0) return static_cast<std::size_t>(i) - 1;
  return i == 0 || i < -length ? 0 : static_cast<std::size_t>(length + i);
}

/// Pushes capture i of a match over [begin, end).
void push_capture(lua_State* state, std::string_view subject, const Matcher& matcher, std::size_t i, std::size_t begin,
                  std::size_t end) {
  const Matcher::Capture capture = matcher.capture(i, begin, end);
  if (capture.length == Matcher::Capture::position) {
    matcher.loop().count();
    lua_pushinteger(state, static_cast<lua_Integer>(capture.begin) + 1);
  } else {
    matcher.loop().count_bytes(capture.length);
    lua_pushlstring(state, subject.data() + capture.begin, capture.length);
  }
}

/// Pushes all captures, or the whole match where the pattern has none; returns how many.
int push_captures(lua_State* state, std::string_view subject, const Matcher& matcher, std::size_t begin,
                  std::size_t end) {
  const std::size_t count = matcher.captures() == 0 ? 1 : matcher.captures();
  luaL_checkstack(state, static_cast<int>(count), "too many captures");
  for (std::size_t i = 0; i < count; i++) push_capture(state, subject, matcher, i, begin, end);
  return static_cast<int>(count);
}

int push_found(lua_State* state, std::size_t begin, std::size_t end) {
  lua_pushinteger(state, static_cast<lua_Integer>(begin) + 1);
  lua_pushinteger(state, static_cast<lua_Integer>(end));
  return 2;
}

/// Takes a ^ off the front of a pattern; true where there was one.
bool take_anchor(std::string_view& pattern) {
  const bool anchored = pattern.starts_with('^');
  if (anchored) pattern.remove_prefix(1);
  return anchored;
}

/// `find`, which tells the place, and `match`.
template <bool place>
int find(lua_State* state) {
  const std::string_view subject = check_string(state, 1);
  std::string_view pattern = check_string(state, 2);
  std::size_t from = check_start(state, 3, subject.size());
  Interruptible loop;
  if (from > subject.size()) return luaL_pushfail(state), 1;
  if (place && (lua_toboolean(state, 4) != 0 || pattern.find_first_of("^$*+?.([%-") == pattern.npos)) {
    const std::size_t found = find_text(subject, pattern, from, loop);
    if (found != Matcher::none) return push_found(state, found, found + pattern.size());
    return luaL_pushfail(state), 1;
  }
  const bool anchored = take_anchor(pattern);
  Matcher matcher(subject, pattern, loop);
  for (; from <= subject.size(); from++) {
    const std::size_t end = matcher.match(from);
    if (end != Matcher::none) {
      if (!place) return push_captures(state, subject, matcher, from, end);
      const int found = push_found(state, from, end);
      return matcher.captures() == 0 ? found : found + push_captures(state, subject, matcher, from, end);
    }
    if (anchored) break;
  }
  return luaL_pushfail(state), 1;
}

/// Upvalues: subject, pattern, where to look next, end of the last match.
int next_match(lua_State* state) {
  const std::string_view subject = check_string(state, lua_upvalueindex(1));
  const std::string_view pattern = check_string(state, lua_upvalueindex(2));
  const lua_Integer last = lua_tointeger(state, lua_upvalueindex(4));
  Interruptible loop;
  Matcher matcher(subject, pattern, loop);
  for (auto from = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))); from <= subject.size();
       from++) {
    const std::size_t end = matcher.match(from);
    if (end == Matcher::none || static_cast<lua_Integer>(end) == last) continue;
    lua_pushinteger(state, static_cast<lua_Integer>(end));
    lua_copy(state, -1, lua_upvalueindex(3));
    lua_replace(state, lua_upvalueindex(4));
    return push_captures(state, subject, matcher, from, end);
  }
  return 0;
}

int gmatch(lua_State* state) {
  const std::size_t size = check_string(state, 1).size();
  check_string(state, 2);
  const std::size_t from = std::min(check_start(state, 3, size), size + 1);
  lua_settop(state, 2);
  lua_pushinteger(state, static_cast<lua_Integer>(from));
  lua_pushinteger(state, -1);
  lua_pushcclosure(state, guard<next_match>, 4);
  return 1;
}

constexpr int replacement = 3;  // place on the stack

/// Adds the replacement string, in which %1 … %9 are captures, %0 is the whole match and %% is %.
void add_text(lua_State* state, luaL_Buffer& buffer, std::string_view subject, const Matcher& matcher,
              std::size_t begin, std::size_t end) {
  std::string_view form = check_string(state, replacement);
  for (;;) {
    const std::size_t percent = form.find('%');
    const std::size_t plain = std::min(percent, form.size());
    matcher.loop().count_bytes(plain);
    luaL_addlstring(&buffer, form.data(), plain);
    if (percent == form.npos) return;
    const char c = percent + 1 < form.size() ? form[percent + 1] : '\0';
    require(c == '%' || (c >= '0' && c <= '9'), "invalid use of '%' in replacement string");
    form.remove_prefix(percent + 2);
    if (c == '%') {
      luaL_addchar(&buffer, '%');
    } else if (c == '0') {
      matcher.loop().count_bytes(end - begin);
      luaL_addlstring(&buffer, subject.data() + begin, end - begin);
    } else {
      push_capture(state, subject, matcher, static_cast<std::size_t>(c - '1'), begin, end);
      luaL_addvalue(&buffer);
    }
  }
}

/// Adds what stands for a match; false where the match stays as it is.
bool add_replacement(lua_State* state, luaL_Buffer& buffer, std::string_view subject, const Matcher& matcher,
                     std::size_t begin, std::size_t end) {
  switch (lua_type(state, replacement)) {
    case LUA_TFUNCTION:
      lua_pushvalue(state, replacement);
      lua_call(state, push_captures(state, subject, matcher, begin, end), 1);
      break;
    case LUA_TTABLE:
      push_capture(state, subject, matcher, 0, begin, end);
      lua_gettable(state, replacement);
      break;
    default: add_text(state, buffer, subject, matcher, begin, end); return true;
  }
  if (!lua_toboolean(state, -1)) {
    lua_pop(state, 1);
    luaL_addlstring(&buffer, subject.data() + begin, end - begin);
    return false;
  }
  require(lua_isstring(state, -1) != 0, "invalid replacement value (a ", luaL_typename(state, -1), ")");
  matcher.loop().count_bytes(lua_rawlen(state, -1));
  luaL_addvalue(&buffer);
  return true;
}

int gsub(lua_State* state) {
  const std::string_view subject = check_string(state, 1);
  std::string_view pattern = check_string(state, 2);
  const int type = lua_type(state, replacement);
  luaL_argexpected(state, type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TFUNCTION || type == LUA_TTABLE,
                   replacement, "string/function/table");
  const bool anchored = take_anchor(pattern);
  const lua_Integer most = luaL_optinteger(state, 4, static_cast<lua_Integer>(subject.size()) + 1);
  Interruptible loop;
  Matcher matcher(subject, pattern, loop);
  luaL_Buffer buffer;
  luaL_buffinit(state, &buffer);
  std::size_t from = 0, last = Matcher::none;
  lua_Integer count = 0;
  bool changed = false;
  while (count < most) {
    const std::size_t end = matcher.match(from);
    if (end != Matcher::none && end != last) {
      count++;
      changed = add_replacement(state, buffer, subject, matcher, from, end) || changed;
      from = last = end;
    } else if (from < subject.size()) {
      luaL_addchar(&buffer, subject[from++]);
    } else {
      break;
    }
    if (anchored) break;
  }
  luaL_addlstring(&buffer, subject.data() + from, subject.size() - from);
  luaL_pushresult(&buffer);
  if (!changed) lua_pushvalue(state, 1);
  lua_pushinteger(state, count);
  return 2;
}

/// string.rep(s, n[, separator])
int repeat(lua_State* state) {
  const std::string_view s = check_string(state, 1);
  const lua_Integer n = luaL_checkinteger(state, 2);
  const std::string_view separator = lua_isnoneornil(state, 3) ? std::string_view{} : check_string(state, 3);
  const std::size_t each = s.size() + separator.size();
  if (n <= 0 || each == 0) return lua_pushliteral(state, ""), 1;
  const auto count = static_cast<std::size_t>(n);
  require(count <= std::size_t{std::numeric_limits<int>::max()} / each, "resulting string too large");
  const std::size_t size = count * each - separator.size(), most = std::max(each, (std::size_t{1} << 20) / each * each);
  Interruptible loop;
  luaL_Buffer buffer;
  char* const to = luaL_buffinitsize(state, &buffer, count * each);
  std::copy(separator.begin(), separator.end(), std::copy(s.begin(), s.end(), to));
  for (std::size_t done = each; done < size;) {
    const std::size_t more = std::min({done, size - done, most});
    loop.count_bytes(more);
    std::memcpy(to + done, to, more);
    done += more;
  }
  luaL_pushresultsize(&buffer, size);
  return 1;
}

constexpr std::size_t longest_quoted = std::size_t{4} << 20;  // [bytes] of all %q: Lua's own takes a while for each
constexpr int most_formatted = 10000;                         // values at once: the same

/// string.format: what %s shows has no address, and %p is refused. Upvalue 1 is Lua's own, which does the rest.
int format(lua_State* state) {
  const std::string_view form = check_string(state, 1);
  const int count = lua_gettop(state);
  int argument = 1;
  std::size_t shown = 0, quoted = 0;  // [bytes]
  for (std::size_t i = form.find('%'); i < form.size(); i = form.find('%', i)) {
    i = form.find_first_not_of("-+ #0123456789.", i + 1);
    if (i >= form.size()) break;
    const char c = form[i++];
    if (c == '%') continue;
    argument++;
    require(argument <= most_formatted + 1, "format: at most ", most_formatted, " values at once");
    require(c != 'p', "format: %p would give an address, which differs from run to run; use %s");
    if (argument > count) continue;
    if (c == 'q' && lua_type(state, argument) == LUA_TSTRING) quoted += lua_rawlen(state, argument);
    require(quoted <= longest_quoted, "format: %q is of at most ", longest_quoted >> 20, " MiB in all");
    if (c != 's') continue;
    push_text(state, argument);
    lua_replace(state, argument);
    shown += lua_rawlen(state, argument);
    require(shown <= longest_string, "format: %s is of at most ", longest_string >> 20, " MiB in all");
  }
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

/// string.pack, whose result is bounded before Lua's own (upvalue 1) fills it.
int pack(lua_State* state) {
  const std::string_view form = check_string(state, 1);
  std::size_t size = 0;
  const auto add = [&](std::size_t more) {
    require(more <= longest_string - size, "pack: strings are of at most ", longest_string >> 20, " MiB in all");
    size += more;
  };
  for (std::size_t i = form.find('c'); i < form.size(); i = form.find('c', i)) {
    std::size_t width = 0;
    for (i++; i < form.size() && form[i] >= '0' && form[i] <= '9'; i++)
      width = std::min(10 * width + static_cast<std::size_t>(form[i] - '0'), longest_string + 1);
    add(width);
  }
  for (int i = 2; i <= lua_gettop(state); i++)
    if (lua_type(state, i) == LUA_TSTRING) add(lua_rawlen(state, i));
  return lua_tocfunction(state, lua_upvalueindex(1))(state);
}

}  // namespace

void open_strings(lua_State* state) {
  const luaL_Reg replaced[] = {{"find", guard<find<true>>}, {"match", guard<find<false>>}, {"gmatch", guard<gmatch>},
                               {"gsub", guard<gsub>},       {"rep", guard<repeat>},        {nullptr, nullptr}};
  lua_getglobal(state, "string");
  lua_pushnil(state);
  lua_setfield(state, -2, "dump");
  luaL_setfuncs(state, replaced, 0);
  replace_call(state, "format", "format", guard<format>);
  replace_call(state, "pack", "pack", guard<pack>);
  lua_pop(state, 1);
}

}  // namespace pantin::lua
