#pragma once
// vec, quat and colours: immutable values.
#include <cstdint>
#include <lua.hpp>
#include <optional>

#include "base/color.hpp"
#include "base/lanes.hpp"

namespace pantin::lua {

/// The first word of every userdata of ours, which are all there are.
enum class Tag : std::uint32_t {
  vec,
  quat,
  ref,
  symbol,
  symbol_vec,
  dual,
  dual_vec,
  law_particle,
  law_own,
  law,
  known_laws
};

std::optional<Tag> tag_of(lua_State* state, int index);

void push(lua_State* state, Vec3 v);
void push(lua_State* state, const Quat& q);
/// "#rrggbb", or "#rrggbbaa" where it is not opaque.
void push(lua_State* state, const Color& color);
std::optional<Vec3> to_vec(lua_State* state, int index);
std::optional<Quat> to_quat(lua_State* state, int index);
/// "#rgb", "#rrggbb", "#rrggbbaa" or { r, g, b[, a] }, 0 … 1.
std::optional<Color> to_color(lua_State* state, int index);

/// Where the registry has the metatable of vecs or quats.
const void* metatable_key(Tag tag);
/// The method of vecs that argument 2 names; upvalue: the methods. Throws Error where there is none.
int push_vec_method(lua_State* state);

/// What Lua's messages call a number of a law that is called.
constexpr const char* number_with_derivative = "number with a derivative";
/// What messages call a value: "a number", "nil", "a vec", "a body".
const char* kind_of_value(lua_State* state, int index);

}  // namespace pantin::lua
