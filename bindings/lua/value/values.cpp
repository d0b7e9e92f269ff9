#include "lua/value/values.hpp"

#include <cmath>
#include <string_view>

#include "base/check.hpp"
#include "fields/color.hpp"
#include "lua/value/ref.hpp"
#include "lua/value/tostring.hpp"

namespace pantin::lua {
namespace {

struct VecData {
  Tag tag;
  double v[3];
};
struct QuatData {
  Tag tag;
  Quat q;
};

}  // namespace

const void* metatable_key(Tag tag) {
  static const char of_vec = 0, of_quat = 0;
  return tag == Tag::vec ? &of_vec : &of_quat;
}

std::optional<Tag> tag_of(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TUSERDATA) return {};
  return *static_cast<const Tag*>(lua_touserdata(state, index));
}

void push(lua_State* state, Vec3 v) {
  auto* data = static_cast<VecData*>(lua_newuserdatauv(state, sizeof(VecData), 0));
  *data = {Tag::vec, {v[0], v[1], v[2]}};
  lua_rawgetp(state, LUA_REGISTRYINDEX, metatable_key(Tag::vec));
  lua_setmetatable(state, -2);
}

void push(lua_State* state, const Quat& q) {
  auto* data = static_cast<QuatData*>(lua_newuserdatauv(state, sizeof(QuatData), 0));
  *data = {Tag::quat, q};
  lua_rawgetp(state, LUA_REGISTRYINDEX, metatable_key(Tag::quat));
  lua_setmetatable(state, -2);
}

void push(lua_State* state, const Color& color) { lua_pushstring(state, fields::text_of(color).c_str()); }

std::optional<Vec3> to_vec(lua_State* state, int index) {
  if (tag_of(state, index) != Tag::vec) return {};
  const auto* data = static_cast<const VecData*>(lua_touserdata(state, index));
  return vec(data->v[0], data->v[1], data->v[2]);
}

std::optional<Quat> to_quat(lua_State* state, int index) {
  if (tag_of(state, index) != Tag::quat) return {};
  return static_cast<const QuatData*>(lua_touserdata(state, index))->q;
}

std::optional<Color> to_color(lua_State* state, int index) {
  if (lua_type(state, index) == LUA_TSTRING) return fields::color_of_text(lua_tostring(state, index));
  if (!lua_istable(state, index)) return {};
  index = lua_absindex(state, index);
  const auto length = lua_rawlen(state, index);
  if (length != 3 && length != 4) return {};
  float part[4] = {0, 0, 0, 1};
  for (lua_Unsigned i = 0; i < length; i++) {
    lua_rawgeti(state, index, static_cast<lua_Integer>(i + 1));
    const bool number = lua_type(state, -1) == LUA_TNUMBER;
    const double value = number ? lua_tonumber(state, -1) : -1.0;
    lua_pop(state, 1);
    if (!(value >= 0.0 && value <= 1.0)) return {};
    part[i] = static_cast<float>(value);
  }
  return Color{part[0], part[1], part[2], part[3]};
}

int push_vec_method(lua_State* state) {
  lua_pushvalue(state, 2);
  lua_rawget(state, lua_upvalueindex(1));
  if (lua_isnil(state, -1))
    throw Error(text("vec: unknown field '", push_text(state, 2),
                     "'; it has x, y, z and the methods dot, cross, length, normalized"));
  return 1;
}

const char* kind_of_value(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNONE:
    case LUA_TNIL: return "nil";
    case LUA_TBOOLEAN: return "a boolean";
    case LUA_TNUMBER: return "a number";
    case LUA_TSTRING: return "a string";
    case LUA_TTABLE: return "a table";
    case LUA_TFUNCTION: return "a function";
    case LUA_TTHREAD: return "a coroutine";
    default: break;
  }
  const auto tag = tag_of(state, index);
  if (!tag) return "a userdata";
  switch (*tag) {
    case Tag::vec:
    case Tag::symbol_vec:
    case Tag::dual_vec: return "a vec";
    case Tag::quat: return "a quat";
    case Tag::ref: return kind_of_thing(*to_ref(state, index));
    case Tag::symbol:
    case Tag::dual: return "a number";
    case Tag::law_particle: return "a particle of a law";
    case Tag::law_own: return "the parameters of a law";
    case Tag::law:
    case Tag::known_laws: break;
  }
  return "a law";
}

}  // namespace pantin::lua
