#include "lua/thing/targets.hpp"

#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {

std::string argument(int number) { return text("argument ", number); }

const Ref& check_thing(lua_State* state, int index, const std::string& call, const std::string& name) {
  const Ref* ref = to_ref(state, index);
  require(ref && !std::holds_alternative<std::monostate>(ref->thing), call, ": ", name,
          " must be a thing of the scene, got ", kind_of_value(state, index));
  require_alive(*ref);
  return *ref;
}

const Ref& check_kind(lua_State* state, int index, Kind kind, const std::string& call, const std::string& name) {
  const Ref* ref = to_ref(state, index);
  require(ref && ref->kind == kind, call, ": ", name, " must be a ", type_of(kind).word, ", got ",
          kind_of_value(state, index));
  require_alive(*ref);
  return *ref;
}

Passage check_point_or_position(lua_State* state, int index, const std::string& call, const std::string& name) {
  if (to_vec(state, index)) return {{}, check_vec(state, index, call, name, "m")};
  require(to_ref(state, index), call, ": ", name, " must be a point, a particle or a vec [m], got ",
          kind_of_value(state, index));
  return {check_point(state, index, call, name), zero3()};
}

PointId check_point(lua_State* state, int index, const std::string& call, const std::string& name) {
  const Ref* ref = to_ref(state, index);
  require(!ref || ref->kind != Kind::body, call, ": ", name,
          " must be a point or a particle, got a body; name one of its points");
  require(ref && (ref->kind == Kind::point || ref->kind == Kind::particle), call, ": ", name,
          " must be a point or a particle, got ", kind_of_value(state, index));
  require_alive(*ref);
  if (ref->kind == Kind::point) return ref->id<PointId>();
  return star(ref->script->world, ref->id<ParticleId>());
}

BodyId check_body(lua_State* state, int index, const std::string& call, const std::string& name) {
  return check_kind(state, index, Kind::body, call, name).id<BodyId>();
}

}  // namespace pantin::lua
