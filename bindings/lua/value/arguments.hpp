#pragma once
// Checking what scripts give. Every check throws Error that names the value, what it must be, and what came.
#include <array>
#include <initializer_list>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/color.hpp"
#include "base/lanes.hpp"
#include "lua/value/callback.hpp"

namespace pantin::lua {

/// A finite number; `what` and `name` begin the message: "body: mass must be a finite number [kg], got NaN".
double check_number(lua_State* state, int index, std::string_view what, std::string_view name, const char* unit);
/// The same, but infinity is allowed.
double check_number_or_infinity(lua_State* state, int index, std::string_view what, std::string_view name,
                                const char* unit);
Vec3 check_vec(lua_State* state, int index, std::string_view what, std::string_view name, const char* unit);
Quat check_quat(lua_State* state, int index, std::string_view what, std::string_view name);
Color check_color(lua_State* state, int index, std::string_view what, std::string_view name);
bool check_boolean(lua_State* state, int index, std::string_view what, std::string_view name);
std::string check_text(lua_State* state, int index, std::string_view what, std::string_view name);
/// The name that a call is given first; not empty.
std::string check_name(lua_State* state, int index, std::string_view what);
Callback check_function(lua_State* state, int index, std::string_view what, std::string_view name);

/// Throws Error where a call has more than `most` arguments, the first of which is at `first`. Values of nil at the end are none.
void check_count(lua_State* state, int most, std::string_view what, int first = 1);

/// Keys of a table, in an order that is the same in every run.
struct KeysOfTable {
  lua_Integer count = 0;           ///< of the list in it
  std::vector<std::string> names;  ///< sorted
  bool has_others = false;
};
KeysOfTable keys_of(lua_State* state, int index);

/// A table of named values: `{ mass = 1, at = vec(0, 1, 0) }`. A name that is not known is an error.
class Options {
 public:
  /// Nothing at `index` is an empty table.
  Options(lua_State* state, int index, std::string what, std::span<const std::string_view> known);
  Options(lua_State* state, int index, std::string what, std::initializer_list<std::string_view> known)
      : Options(state, index, std::move(what), std::span(known.begin(), known.size())) {}
  Options(lua_State* state, int index, std::string what, const std::vector<std::string>& known)
      : Options(state, index, std::move(what), std::vector<std::string_view>(known.begin(), known.end())) {}

  bool has(const char* key) const;
  /// Pushes the value, or nil, and returns its index.
  int push(const char* key) const;
  std::optional<double> number(const char* key, const char* unit) const;
  std::optional<double> number_or_infinity(const char* key, const char* unit) const;
  std::optional<Vec3> vector(const char* key, const char* unit) const;
  std::optional<Quat> quat(const char* key) const;
  std::optional<Color> color(const char* key) const;
  std::optional<bool> boolean(const char* key) const;
  std::optional<std::string> string(const char* key) const;
  std::optional<Callback> function(const char* key) const;
  const std::string& what() const { return what_; }
  lua_State* state() const { return state_; }

 private:
  bool may_have(const char* key) const;
  template <class Read>
  auto read(const char* key, Read&& read) const;

  lua_State* state_;
  int index_ = 0;                       ///< 0: no table was given
  std::array<const char*, 8> given_{};  ///< names in the table, where there are no more
  std::size_t given_count_ = 0;
  std::string what_;
};

/// Fails with `instead`, what to do, where one of `names` is given: what one may know from elsewhere.
void refuse_options(lua_State* state, int index, const std::string& what, std::initializer_list<const char*> names,
                    const char* instead);
/// " Did you mean 'mass'?" where one of the names is near, else "".
std::string suggestion(const std::string& name, const std::vector<std::string>& names);
/// "a, b, c"
std::string joined(const std::vector<std::string>& names);

}  // namespace pantin::lua
