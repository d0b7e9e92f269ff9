#include "lua/thing/property_values.hpp"

#include "lua/law/curve_options.hpp"
#include "lua/thing/body_options.hpp"
#include "lua/thing/constraint_values.hpp"
#include "lua/thing/emitter_options.hpp"
#include "lua/thing/point_constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"

namespace pantin::lua {
namespace {

using fields::Form;
using fields::Property;

struct Pushing {
  lua_State* state;
  Script& script;

  void operator()(std::monostate) const { lua_pushnil(state); }
  void operator()(double number) const { lua_pushnumber(state, number); }
  void operator()(std::int64_t whole) const { lua_pushinteger(state, whole); }
  void operator()(bool truth) const { lua_pushboolean(state, truth); }
  void operator()(const std::string& text) const { lua_pushlstring(state, text.data(), text.size()); }
  void operator()(Vec3 v) const { push(state, v); }
  void operator()(const Quat& q) const { push(state, q); }
  void operator()(const Color& color) const { push(state, color); }
  void operator()(const AnyId& thing) const { push_thing(state, script, thing); }
  void operator()(const fields::Things& things) const { push_list(state, script, things); }
  void operator()(const Mat3& inertia) const { push_inertia(state, inertia); }
  void operator()(const Breaking& breaks_at) const { push_breaking(state, breaks_at); }
  void operator()(const fields::Table& table) const {
    const bool list = !table.empty() && table.front().name.empty();
    const int count = static_cast<int>(table.size());
    lua_createtable(state, list ? count : 0, list ? 0 : count);
    lua_Integer i = 0;
    for (const fields::Entry& entry : table) {
      if (!list) lua_pushlstring(state, entry.name.data(), entry.name.size());
      push_value(state, script, entry.value);
      if (list)
        lua_rawseti(state, -2, ++i);
      else
        lua_rawset(state, -3);
    }
  }
  void operator()(const fields::Lifetimes& lifetimes) const {
    (*this)(fields::Table{{"min", lifetimes.shortest}, {"max", lifetimes.longest}});
  }
  /// Those are read as what they are now.
  template <class Function>
  void operator()(const Function&) const {
    assume(false);
    lua_pushnil(state);
  }
};

/// The number that a constraint keeps, or none.
KeptNumber kept_by(const Self& self) {
  if (!is_constraint(self.ref.kind)) return {};
  return rule_of(self.world.constraints[self.ref.id<ConstraintId>()]).keeps;
}

/// The function at `index`, where the form has functions; nothing otherwise.
fields::Value check_function_of(const Self& self, const Property& p, const char* word, int index) {
  const auto of_time = [&](auto make) -> fields::Value {
    return make(Callback(self.state, index), text(word, ": ", p.name));
  };
  switch (p.form) {
    case Form::number_of_time:
      return number_of_time(Callback(self.state, index), text(word, ": ", p.name), kept_by(self));
    case Form::rate_of_time: return rate_function(Callback(self.state, index));
    case Form::vec_of_time: return of_time(position_of_time);
    case Form::quat_of_time: return of_time(quat_of_time);
    case Form::number_of_age:
    case Form::color_of_age: return curve_of(self.state, index, word, p.name);
    default: return {};
  }
}

}  // namespace

void push_value(lua_State* state, Script& script, const fields::Value& value) {
  if (const auto* vector = std::get_if<Vec3>(&value)) return push(state, *vector);  // most of what scripts read
  std::visit(Pushing{state, script}, value);
}

fields::Value check_value(const Self& self, const Property& p, int index) {
  lua_State* state = self.state;
  const char* word = p.word ? p.word : type_of(self.ref.kind).word;
  if (p.or_nothing && lua_isnil(state, index)) return {};
  if (lua_isfunction(state, index))
    if (fields::Value function = check_function_of(self, p, word, index); function.index() != 0) return function;
  const char* unit = fields::unit_in_messages(p);
  switch (p.form) {
    case Form::number:
    case Form::number_of_time:
    case Form::rate_of_time:
    case Form::number_of_age:
      return p.or_infinity ? check_number_or_infinity(state, index, word, p.name, unit)
                           : check_number(state, index, word, p.name, unit);
    case Form::boolean: return check_boolean(state, index, word, p.name);
    case Form::text: return check_text(state, index, word, p.name);
    case Form::vec:
    case Form::vec_of_time: return check_vec(state, index, word, p.name, unit);
    case Form::quat:
    case Form::quat_of_time: return check_quat(state, index, word, p.name);
    case Form::color:
    case Form::color_of_age: return check_color(state, index, word, p.name);
    case Form::family: return AnyId(check_kind(state, index, Kind::family, word, p.name).id<FamilyId>());
    case Form::breaking: return check_breaking(state, index, text(word, ": ", p.name), p.parts);
    case Form::inertia: return check_inertia(state, index, word);
    case Form::place: return check_emitter_position(state, index, word);
    case Form::lifetimes: {
      const auto [shortest, longest] = check_lifetimes(state, index, word);
      return fields::Lifetimes{shortest, longest};
    }
    case Form::none: break;
  }
  throw Error(text(word, ": ", p.name, " can be read, not written"));
}

}  // namespace pantin::lua
