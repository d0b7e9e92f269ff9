#include "lua/value/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/interruptible.hpp"
#include "fields/check.hpp"
#include "lua/value/copies.hpp"
#include "lua/value/values.hpp"

namespace pantin::lua {
namespace {

/// Number of letters to insert, delete or change (Levenshtein 1966), or `most` where it is no less.
std::size_t distance(const std::string& a, const std::string& b, std::size_t most) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) >= most) return most;
  Interruptible loop;
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); j++) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); i++) {
    std::size_t diagonal = row[0];
    row[0] = i;
    loop.count_bytes(b.size());
    for (std::size_t j = 1; j <= b.size(); j++) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

double check_number_or_infinity(lua_State* state, int index, std::string_view what, std::string_view name,
                                const char* unit) {
  require(lua_type(state, index) == LUA_TNUMBER, what, ": ", name, " must be a number", fields::in_brackets(unit),
          ", got ", kind_of_value(state, index));
  const double value = lua_tonumber(state, index);
  require(!std::isnan(value), what, ": ", name, " must be a number", fields::in_brackets(unit), ", got NaN");
  return value;
}

double check_number(lua_State* state, int index, std::string_view what, std::string_view name, const char* unit) {
  require(lua_type(state, index) == LUA_TNUMBER, what, ": ", name, " must be a number", fields::in_brackets(unit),
          ", got ", kind_of_value(state, index));
  const double value = lua_tonumber(state, index);
  fields::check_finite(value, what, name, unit);
  return value;
}

Vec3 check_vec(lua_State* state, int index, std::string_view what, std::string_view name, const char* unit) {
  const auto v = to_vec(state, index);
  require(v.has_value(), what, ": ", name, " must be a vec", fields::in_brackets(unit), ", got ",
          kind_of_value(state, index));
  fields::check_finite(*v, what, name, unit);
  return *v;
}

Quat check_quat(lua_State* state, int index, std::string_view what, std::string_view name) {
  const auto q = to_quat(state, index);
  require(q.has_value(), what, ": ", name, " must be a quat, got ", kind_of_value(state, index));
  return *q;
}

Color check_color(lua_State* state, int index, std::string_view what, std::string_view name) {
  const auto color = to_color(state, index);
  if (color) return *color;
  const std::string got = lua_type(state, index) == LUA_TSTRING ? text("\"", lua_tostring(state, index), "\"")
                                                                : kind_of_value(state, index);
  throw Error(text(what, ": ", name,
                   " must be a color, \"#rgb\", \"#rrggbb\", \"#rrggbbaa\" or { r, g, b, a } of 0 to 1, got ", got));
}

bool check_boolean(lua_State* state, int index, std::string_view what, std::string_view name) {
  require(lua_isboolean(state, index), what, ": ", name, " must be true or false, got ", kind_of_value(state, index));
  return lua_toboolean(state, index) != 0;
}

std::string check_text(lua_State* state, int index, std::string_view what, std::string_view name) {
  require(lua_type(state, index) == LUA_TSTRING, what, ": ", name, " must be a string, got ",
          kind_of_value(state, index));
  std::size_t size = 0;
  const char* s = lua_tolstring(state, index, &size);
  require(std::memchr(s, 0, size) == nullptr, what, ": ", name, " must have no byte of zero");
  return {s, size};
}

std::string check_name(lua_State* state, int index, std::string_view what) {
  std::string name = check_text(state, index, what, "argument 1, the name,");
  require(!name.empty(), what, ": argument 1, the name, must not be empty");
  return name;
}

Callback check_function(lua_State* state, int index, std::string_view what, std::string_view name) {
  require(lua_isfunction(state, index), what, ": ", name, " must be a function, got ", kind_of_value(state, index));
  return Callback(state, index);
}

void check_count(lua_State* state, int most, std::string_view what, int first) {
  for (int i = lua_gettop(state); i >= most + first; i--)
    require(lua_isnil(state, i), what, ": takes ", most == 0 ? "no" : "at most " + std::to_string(most),
            most == 1 ? " argument" : " arguments", ", got ", i - first + 1,
            "; a call that comes last gives all its values, and in parentheses, (f()), the first");
}

KeysOfTable keys_of(lua_State* state, int index) {
  const int table = lua_absindex(state, index);
  unlock(state, table);
  KeysOfTable keys;
  keys.count = static_cast<lua_Integer>(lua_rawlen(state, table));
  Interruptible loop;
  for (lua_pushnil(state); lua_next(state, table); lua_pop(state, 1)) {
    loop.count();
    const lua_Integer place = lua_isinteger(state, -2) ? lua_tointeger(state, -2) : 0;
    if (lua_type(state, -2) == LUA_TSTRING)
      keys.names.emplace_back(lua_tostring(state, -2), lua_rawlen(state, -2));
    else
      keys.has_others = keys.has_others || place < 1 || place > keys.count;
  }
  std::sort(keys.names.begin(), keys.names.end(), [&](const std::string& a, const std::string& b) {
    loop.count_bytes(std::min(a.size(), b.size()));
    return a < b;
  });
  return keys;
}

Options::Options(lua_State* state, int index, std::string what, std::span<const std::string_view> known)
    : state_(state), what_(std::move(what)) {
  if (lua_isnoneornil(state, index)) return;
  require(lua_istable(state, index), what_, ": the options must be a table { name = value }, got ",
          kind_of_value(state, index));
  index_ = lua_absindex(state, index);
  unlock(state, index_);
  std::vector<std::string> wrong;  // the order of lua_next differs from run to run
  lua_pushnil(state);
  while (lua_next(state, index_)) {
    lua_pop(state, 1);
    if (lua_type(state, -1) == LUA_TSTRING) {
      const std::string_view key = lua_tostring(state, -1);
      if (std::find(known.begin(), known.end(), key) == known.end()) wrong.emplace_back(key);
      if (given_count_ < given_.size()) given_[given_count_] = key.data();
      given_count_++;
    } else {
      wrong.push_back(lua_isinteger(state, -1) ? text(lua_tointeger(state, -1)) : kind_of_value(state, -1));
    }
  }
  if (wrong.empty()) return;
  const std::vector<std::string> names(known.begin(), known.end());
  const std::string& key = *std::min_element(wrong.begin(), wrong.end());
  const bool numbered = key.find_first_not_of("0123456789") == std::string::npos;
  throw Error(text(what_, ": unknown field '", key, "'.",
                   numbered ? " Each value needs its name, { name = value }." : suggestion(key, names), " Known are ",
                   joined(names)));
}

void refuse_options(lua_State* state, int index, const std::string& what, std::initializer_list<const char*> names,
                    const char* instead) {
  if (!lua_istable(state, index)) return;
  for (const char* name : names) {
    lua_pushstring(state, name);
    const bool given = lua_rawget(state, index) != LUA_TNIL;
    lua_pop(state, 1);
    if (given) throw Error(text(what, ": there is no '", name, "' here. ", instead));
  }
}

bool Options::may_have(const char* key) const {
  if (given_count_ > given_.size()) return true;
  const auto end = given_.begin() + static_cast<std::ptrdiff_t>(given_count_);
  return std::find_if(given_.begin(), end, [&](const char* name) { return std::strcmp(name, key) == 0; }) != end;
}

bool Options::has(const char* key) const {
  push(key);
  const bool given = !lua_isnil(state_, -1);
  lua_pop(state_, 1);
  return given;
}

int Options::push(const char* key) const {
  if (!may_have(key)) {
    lua_pushnil(state_);
  } else {
    lua_pushstring(state_, key);
    lua_rawget(state_, index_);
    unlock(state_, lua_gettop(state_));
  }
  return lua_gettop(state_);
}

template <class Read>
auto Options::read(const char* key, Read&& read) const {
  std::optional<decltype(read(0))> value;
  const int at = push(key);
  if (!lua_isnil(state_, at)) value.emplace(read(at));
  lua_pop(state_, 1);
  return value;
}

std::optional<double> Options::number(const char* key, const char* unit) const {
  return read(key, [&](int at) { return check_number(state_, at, what_, key, unit); });
}
std::optional<double> Options::number_or_infinity(const char* key, const char* unit) const {
  return read(key, [&](int at) { return check_number_or_infinity(state_, at, what_, key, unit); });
}
std::optional<Vec3> Options::vector(const char* key, const char* unit) const {
  return read(key, [&](int at) { return check_vec(state_, at, what_, key, unit); });
}
std::optional<Quat> Options::quat(const char* key) const {
  return read(key, [&](int at) { return check_quat(state_, at, what_, key); });
}
std::optional<Color> Options::color(const char* key) const {
  return read(key, [&](int at) { return check_color(state_, at, what_, key); });
}
std::optional<bool> Options::boolean(const char* key) const {
  return read(key, [&](int at) { return check_boolean(state_, at, what_, key); });
}
std::optional<std::string> Options::string(const char* key) const {
  return read(key, [&](int at) { return check_text(state_, at, what_, key); });
}
std::optional<Callback> Options::function(const char* key) const {
  return read(key, [&](int at) { return check_function(state_, at, what_, key); });
}

std::string suggestion(const std::string& name, const std::vector<std::string>& names) {
  std::size_t nearest = 3;
  std::string best;
  for (const std::string& candidate : names) {
    const std::size_t d = distance(name, candidate, nearest);
    if (d < nearest && d < candidate.size()) {
      nearest = d;
      best = candidate;
    }
  }
  return best.empty() ? "" : text(" Did you mean '", best, "'?");
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace pantin::lua
